// Iterations on the bolted joint when METIS cuts every plate into 1, 2, 4, 8 and 16 pieces:
//   cut_plates xml/bolted_joint.xml
// Exit code 1 when a cut needs more than 1.2 times the iterations of the whole plates.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <Tpetra_Core.hpp>

#include "Study.hpp"

namespace {

using namespace harmos;

constexpr double allowedGrowth = 1.2;
constexpr double level = 1e-3;

using Curves = std::vector<std::vector<double>>;

/// Largest distance of the curves of all responses, each relative to its largest value.
double distance(const Curves& curves, const Curves& reference) {
  double largest = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    double size = 0.0;
    double difference = 0.0;
    for (std::size_t t = 0; t < reference[i].size(); ++t) {
      size = std::max(size, std::abs(reference[i][t]));
      difference = std::max(difference, std::abs(reference[i][t] - curves[i][t]));
    }
    largest = std::max(largest, difference / size);
  }
  return largest;
}

Curves curvesOf(const latin::LatinResult& result) {
  Curves curves;
  for (const auto& response : result.responses) curves.push_back(response.values);
  return curves;
}

struct Count {
  int bodies = 0;
  int macroUnknowns = 0;
  latin::LatinResult result;
};

Count solve(const std::string& path, int pieces, double accuracy) {
  benchmarks::Overrides overrides{"Solver/Accuracy=" + std::to_string(accuracy)};
  for (const char* plate : {"cover_bottom", "centre", "cover_top"})
    overrides.push_back("Parts/" + std::string(plate) + "/Pieces=" + std::to_string(pieces));
  const benchmarks::Study study(path, overrides);
  base::Timers timers;
  latin::LatinSolver solver(study.problem.assembly, study.options, Tpetra::getDefaultComm(), timers);
  for (const auto& response : study.problem.responses) solver.addResponse(response);
  Count count;
  count.bodies = static_cast<int>(study.problem.assembly.bodies.size());
  count.macroUnknowns = solver.fixedPoint().linearStage().macroUnknowns();
  count.result = solver.solve();
  return count;
}

int measure(const std::vector<std::string>& arguments) {
  if (arguments.size() != 1) {
    std::cerr << "usage: cut_plates xml/bolted_joint.xml\n";
    return 2;
  }
  const Curves reference = curvesOf(solve(arguments[0], 1, 1e-6).result);
  std::printf(
      "| pieces per plate | bodies | macro unknowns | linear stages before the certificate | growth | linear stages in "
      "all | outcome | estimate | true error |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  double whole = 0.0;
  bool isBelow = true;
  for (const int pieces : {1, 2, 4, 8, 16}) {
    const Count count = solve(arguments[0], pieces, level);
    if (pieces == 1) whole = count.result.iterations;
    const double growth = count.result.iterations / whole;
    const bool isCertified = count.result.outcome == latin::Outcome::certified;
    std::printf("| %d | %d | %d | %d | %.2f | %d | %s | %.1e | %.1e |\n", pieces, count.bodies, count.macroUnknowns,
                count.result.iterations, growth, count.result.linearStages, isCertified ? "certified" : "not certified",
                count.result.errorEstimate, distance(curvesOf(count.result), reference));
    std::fflush(stdout);
    isBelow = isBelow && isCertified && growth <= allowedGrowth;
  }
  return isBelow ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, measure);
}
