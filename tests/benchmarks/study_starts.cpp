// A parametric study of the bolted joint, displacement-driven, on the grid of friction and two preloads:
//   study_starts xml/bolted_joint.xml [--accuracy 1e-2] [--configurations 60] [--checks 20]
// prints linear stages and CPU per configuration, warm against cold, and the true errors of random configurations
// against solutions iterated to round-off. Without --configurations: all 1296. Exit code 1 on a false claim.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <map>
#include <numeric>
#include <random>

#include <Tpetra_Core.hpp>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/laws/LawRegistry.hpp>
#include <harmos/parametric/ParametricStudy.hpp>

#include "Study.hpp"

namespace {

using namespace harmos;

constexpr int coldRuns = 8;

double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<design::Configuration> grid() {
  std::vector<design::Configuration> all;
  for (int mu = 0; mu < 9; ++mu) {
    for (int one = 0; one < 12; ++one) {
      for (int two = 0; two < 12; ++two) {
        all.push_back({static_cast<int>(all.size()) + 1, {0.1 + 0.05 * mu, 0.025 * (one + 1), 0.025 * (two + 1)}});
      }
    }
  }
  return all;
}

/// `count` of 0 .. size - 1, the same in every run.
std::vector<int> sample(int size, int count, unsigned seed) {
  std::vector<int> all(size);
  std::iota(all.begin(), all.end(), 0);
  std::shuffle(all.begin(), all.end(), std::mt19937(seed));
  all.resize(std::min(size, count));
  return all;
}

/// The scene whose laws change.
class Joint {
 public:
  explicit Joint(const std::string& path) : path_(path), scene_(read({0.3, 0.1, 0.1})) {
    base::Timers timers;
    problem = scene::makeProblem(scene_, *Tpetra::getDefaultComm(), timers);
    options = latin::LatinOptions(scene_.input.list("Solver"));
  }
  Joint(const Joint&) = delete;
  Joint& operator=(const Joint&) = delete;

  void install(const std::vector<double>& values) {
    const scene::Scene scene = read(values);
    for (assembly::Interface& interface : problem.assembly.interfaces) {
      interface.law = scene.laws.at(interface.name);
    }
  }

  scene::Problem problem;
  latin::LatinOptions options;

 private:
  scene::Scene read(const std::vector<double>& values) const {
    benchmarks::Overrides overrides = benchmarks::displacementDriven();
    overrides.resize(2);
    const char* const names[] = {"mu", "preload_1", "preload_2"};
    for (std::size_t p = 0; p < values.size(); ++p) {
      overrides.push_back("Values/" + std::string(names[p]) + "=" + std::to_string(values[p]));
    }
    return scene::readScene(path_, overrides, laws::builtInLaws());
  }

  std::string path_;
  scene::Scene scene_;
};

class Results : public results::ResultSink {
 public:
  void record(const results::ConfigurationResult& result) override {
    if (all.emplace(result.id, result).second && all.size() % 50 == 0) {
      std::fprintf(stderr, "%zu configurations, %.0f s CPU\n", all.size(), cpuSeconds());
    }
    all[result.id] = result;
  }
  std::map<int, results::ConfigurationResult> all;
};

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Iterates until the residual |T(alpha) - alpha| / |T(alpha)| is 1e-9 or stagnates.
const latin::Iterate& converge(latin::FixedPoint& fixedPoint, int memory) {
  base::Matrix alpha(fixedPoint.layout().rows(), fixedPoint.assembly().steps()), image(alpha), residual(alpha);
  latin::AndersonAcceleration acceleration(fixedPoint.metric(), memory);
  for (int i = 0; i < 250; ++i) {
    const latin::Iterate& iterate = fixedPoint.apply(alpha, image);
    residual.assign(image);
    residual -= alpha;
    if (fixedPoint.metric().norm(residual) <= 1e-9 * fixedPoint.metric().norm(image)) return iterate;
    acceleration.advance(alpha, image);
  }
  return fixedPoint.apply(alpha, image);
}

double forceFieldError(const base::Matrix& exact, const base::Matrix& other, const std::vector<double>& area) {
  double error = 0.0, size = 0.0;
  for (int t = 0; t < exact.numCols(); ++t) {
    double errorHere = 0.0, sizeHere = 0.0;
    for (std::size_t row = 0; row < area.size(); ++row) {
      const double difference = exact[t][row] - other[t][row];
      errorHere += area[row] * difference * difference;
      sizeHere += area[row] * exact[t][row] * exact[t][row];
    }
    error = std::max(error, errorHere);
    size = std::max(size, sizeHere);
  }
  return std::sqrt(error / size);
}

double responseError(const latin::Iterate& exact, const Joint& joint, const std::vector<std::vector<double>>& curves) {
  const latin::NaturalSizes sizes(exact);
  double worst = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    double size = sizes.floor(joint.problem.responses[i]->quantity()), difference = 0.0;
    const std::vector<double> values = joint.problem.responses[i]->evaluate(exact);
    for (std::size_t t = 0; t < values.size(); ++t) {
      size = std::max(size, std::abs(values[t]));
      difference = std::max(difference, std::abs(values[t] - curves[i][t]));
    }
    worst = std::max(worst, difference / size);
  }
  return worst;
}

int measure(std::vector<std::string> arguments) {
  const double accuracy = benchmarks::optionOf(arguments, "--accuracy", 1e-2);
  const int count = static_cast<int>(benchmarks::optionOf(arguments, "--configurations", 1296));
  const int checks = static_cast<int>(benchmarks::optionOf(arguments, "--checks", 20));
  if (arguments.size() != 1) {
    std::cerr << "usage: study_starts xml/bolted_joint.xml [--accuracy 1e-2] [--configurations 60] [--checks 20]\n";
    return 2;
  }
  Joint joint(arguments[0]);
  joint.options.accuracy = accuracy;
  const std::vector<design::Configuration> all = grid();
  std::vector<design::Configuration> open;
  std::vector<int> chosen = sample(static_cast<int>(all.size()), count, 1);
  std::sort(chosen.begin(), chosen.end());
  for (int i : chosen) open.push_back(all[i]);
  std::map<int, base::Matrix> checked;  // tractions f^
  for (int i : sample(static_cast<int>(open.size()), checks, 2)) checked[open[i].id] = {};

  base::Timers timers;
  const auto comm = Tpetra::getDefaultComm();
  parametric::ParametricStudy engine(
      joint.problem.assembly, [&](const auto& values) { joint.install(values); }, joint.problem.responses,
      parametric::optionsForStudy(joint.options, open.size(), joint.problem.assembly.steps()), comm, timers);
  engine.setObserver([&](const design::Configuration& configuration, latin::FixedPoint&, const latin::Iterate& state) {
    const auto found = checked.find(configuration.id);
    if (found != checked.end()) found->second = state.hattedTraction();
  });
  Results results;
  const double begin = cpuSeconds();
  engine.run(open, results);
  const double studySeconds = cpuSeconds() - begin;

  std::vector<int> stages;
  std::map<results::Status, int> ends;
  for (const auto& [id, result] : results.all) {
    stages.push_back(result.linearStages);
    ++ends[result.status];
  }
  std::sort(stages.begin(), stages.end());
  const double mean = std::accumulate(stages.begin(), stages.end(), 0.0) / static_cast<double>(stages.size());
  const parametric::Trust& summary = engine.summary();
  parametric::Calibration calibration(accuracy, joint.problem.responses.size());
  for (int run = 0; run < summary.calibrations + summary.audits; ++run) calibration.add(summary.ratios);
  std::printf("accuracy %g, %zu configurations: %d calibrated, %d certified, %d others\n", accuracy, stages.size(),
              ends[results::Status::calibrated], ends[results::Status::certified],
              static_cast<int>(stages.size()) - ends[results::Status::calibrated] - ends[results::Status::certified]);
  std::printf(
      "kf %.3g, kc %.3g from %d calibrations; %d audits, %d without end, %d false, largest error %.2f of the accuracy; "
      "at most "
      "%.1f %% false claims at 95 %% confidence; %d taken up again\n",
      summary.ratios.force, summary.ratios.responses.front(), summary.calibrations, summary.audits, summary.openAudits,
      summary.falseClaims, summary.largestAudit, 100.0 * summary.falseClaimBound, summary.reopened);

  // Cold runs: what a certificate costs, and the same stop as in the study.
  std::vector<int> certifiedStages, sameStopStages;
  double certifiedSeconds = 0.0, sameStopSeconds = 0.0;
  {
    base::Timers unused;
    latin::LatinSolver solver(joint.problem.assembly,
                              parametric::optionsForStudy(joint.options, open.size(), joint.problem.assembly.steps()),
                              comm, unused);
    for (const auto& response : joint.problem.responses) solver.addResponse(response);
    parametric::StepSolver steps(solver.fixedPoint(), substructure::Precision::exact);
    parametric::ConfigurationIteration iteration(solver.fixedPoint(), steps, joint.problem.responses,
                                                 {0, 0, joint.options.memory}, joint.options.accuracy, unused);
    for (int i : sample(static_cast<int>(open.size()), coldRuns, 3)) {
      const design::Configuration& configuration = open[i];
      joint.install(configuration.values);
      double start = cpuSeconds();
      certifiedStages.push_back(solver.solve().linearStages);
      certifiedSeconds += cpuSeconds() - start;
      start = cpuSeconds();
      iteration.begin(parametric::SolvedStates(1), configuration.values);
      results::Indicators target = calibration.target();
      while (!calibration.accepts(iteration.march(target)) && iteration.stages() < 300)
        target = parametric::tightened(0.5, target, target);
      sameStopStages.push_back(iteration.stages());
      sameStopSeconds += cpuSeconds() - start;
    }
  }
  const auto meanOf = [](const std::vector<int>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  std::printf("| per configuration | linear stages | CPU s |\n|---|---|---|\n");
  std::printf("| cold, certified (%d runs) | %.1f | %.3f |\n", coldRuns, meanOf(certifiedStages),
              certifiedSeconds / coldRuns);
  std::printf("| cold, the study's stop (%d runs) | %.1f | %.3f |\n", coldRuns, meanOf(sameStopStages),
              sameStopSeconds / coldRuns);
  std::printf("| study, everything included | %.2f | %.3f |\n", mean,
              studySeconds / static_cast<double>(stages.size()));
  std::printf("| study, median | %d | |\n", stages[stages.size() / 2]);
  std::printf("whole study: %.0f s CPU\n", studySeconds);
  for (const auto& phase : timers.phases()) std::printf("  %s %.1f s\n", phase.name.c_str(), phase.cpuSeconds);

  int falseClaims = 0;
  double worst = 0.0, leastRatio = 1e9, largestRatio = 0.0;
  latin::FixedPoint fixedPoint(joint.problem.assembly, joint.options.stages, comm, timers);
  for (const auto& [id, traction] : checked) {
    const results::ConfigurationResult& result = results.all[id];
    if (traction.numRows() == 0) continue;
    joint.install(all[id - 1].values);
    fixedPoint.updateLaws();
    const latin::Iterate& exact = converge(fixedPoint, joint.options.memory);
    const double error = std::max(responseError(exact, joint, result.curves),
                                  forceFieldError(exact.hattedTraction(), traction, exact.layout().area()));
    falseClaims += error > accuracy ? 1 : 0;
    worst = std::max(worst, error);
    leastRatio = std::min(leastRatio, result.errorEstimate / error);
    largestRatio = std::max(largestRatio, result.errorEstimate / error);
  }
  std::printf("%zu checked: %d false, largest true error %.2g, estimate / true error from %.2f to %.2f\n",
              checked.size(), falseClaims, worst, leastRatio, largestRatio);
  const std::vector<std::pair<std::vector<double>, double>> references = {
      {{0.25, 0.1, 0.1}, 3259.2102}, {{0.25, 0.125, 0.1}, 3668.9484}, {{0.30, 0.15, 0.125}, 5388.7439}};
  for (const auto& [values, force] : references) {
    for (const design::Configuration& configuration : open) {
      double distance = 0.0;
      for (std::size_t p = 0; p < 3; ++p) distance += std::abs(configuration.values[p] - values[p]);
      if (distance > 1e-9) continue;
      std::printf("F_max at (%.2f, %.3f, %.3f): %.2f N, reference %.2f N\n", values[0], values[1], values[2],
                  largest(results.all[configuration.id].curves[1]), force);
    }
  }
  return falseClaims == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, measure);
}
