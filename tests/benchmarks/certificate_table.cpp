// What the certificate costs and whether it holds, as a table on standard output:
//   certificate_table xml/bolted_joint.xml tests/extremes/*.xml lap.xml::Values/traction=12
// Every scene is solved by the default algorithm at accuracies of 1e-2, 1e-3 and 1e-4, and compared with its truth.
// Settings follow the scene's path, each after two colons; "driven" stands for those that make the bolted joint
// displacement-driven. Options: --iterations N (1000), the largest number of linear stages of a run; --truth A (1e-8),
// the accuracy of the truth. Exit code 1 when a certified run has a true error above what was asked for, or an estimate
// below a third of its true error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <harmos/base/Error.hpp>

#include "Solution.hpp"

namespace {

using namespace harmos;

constexpr std::array<double, 3> accuracies{1e-2, 1e-3, 1e-4};
constexpr double smallestRatio = 1.0 / 3.0;

struct Totals {
  int claims = 0;
  int wrong = 0;
  int low = 0;  // of claims: estimates below smallestRatio
  double smallest = 1e300, largest = 0.0;
};

/// The scene of an argument: path, then settings, each after "::".
std::unique_ptr<benchmarks::Study> read(const std::string& argument) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 2) {
    end = argument.find("::", begin);
    parts.push_back(argument.substr(begin, end == std::string::npos ? end : end - begin));
  }
  benchmarks::Overrides overrides(parts.begin() + 1, parts.end());
  if (overrides == benchmarks::Overrides{"driven"}) overrides = benchmarks::displacementDriven();
  return std::make_unique<benchmarks::Study>(parts[0], overrides);
}

void writeRow(const std::string& name, const benchmarks::Study& study, const benchmarks::Solution* truth,
              double accuracy, int iterations, Totals& totals) {
  latin::LatinOptions options = study.options;
  options.accuracy = accuracy;
  options.maximumIterations = iterations;
  const benchmarks::Solution run(study, options);
  const latin::LatinResult& result = run.result();
  std::string status = run.isCertified()                                 ? "certified"
                       : result.outcome == latin::Outcome::noEquilibrium ? "no equilibrium"
                                                                         : "not certified";
  std::string errors = "- | - | -";
  if (truth != nullptr) {
    const benchmarks::Solution::Error error = truth->errorOf(run);
    const double roundOff = std::max(10.0 * truth->result().errorEstimate, 1e-9);
    const double ratio = error.relative > roundOff ? result.errorEstimate / error.relative : std::nan("");
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.1e | %.1e | %.2f", result.errorEstimate, error.relative, ratio);
    errors = text.data();
    if (run.isCertified()) {
      ++totals.claims;
      if (!(error.relative <= accuracy)) {
        ++totals.wrong;
        status = "**wrong** (" + error.quantity + ")";
      }
      if (std::isfinite(ratio)) {
        totals.smallest = std::min(totals.smallest, ratio);
        totals.largest = std::max(totals.largest, ratio);
        if (ratio < smallestRatio) {
          ++totals.low;
          status += ", **low**";
        }
      }
    }
  }
  std::printf("| %s | %g | %s | %d | %d | %.2f | %s |\n", name.c_str(), accuracy, status.c_str(), result.iterations,
              result.linearStages - result.iterations, run.cpuSeconds(), errors.c_str());
  std::fflush(stdout);
}

int measure(std::vector<std::string> arguments) {
  const int iterations = static_cast<int>(benchmarks::optionOf(arguments, "--iterations", 1000));
  const double accuracyOfTruth = benchmarks::optionOf(arguments, "--truth", 1e-8);
  if (arguments.empty()) {
    std::cerr << "usage: certificate_table [--iterations N] [--truth A] SCENE.xml[::SETTING]... ...\n";
    return 2;
  }
  std::printf(
      "| scene | accuracy | status | stages of the march | of the certificate | CPU [s] | estimate | true error | "
      "estimate / true |\n|---|---|---|---|---|---|---|---|---|\n");
  Totals totals;
  for (const std::string& argument : arguments) {
    const std::string name = argument.substr(argument.find_last_of('/', argument.find("::")) + 1);
    try {
      const std::unique_ptr<benchmarks::Study> study = read(argument);
      const std::unique_ptr<benchmarks::Solution> truth = benchmarks::truthOf(*study, accuracyOfTruth * 1e6);
      for (const double accuracy : accuracies) writeRow(name, *study, truth.get(), accuracy, iterations, totals);
    } catch (const base::Error& error) {
      std::printf("| %s | | failed: %s | | | | | | |\n", name.c_str(), error.what());
    }
  }
  std::printf("\n%d claims, %d wrong; estimate / true %.2f to %.2f, %d below %.2f\n", totals.claims, totals.wrong,
              totals.smallest, totals.largest, totals.low, smallestRatio);
  return totals.wrong + totals.low == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, measure);
}
