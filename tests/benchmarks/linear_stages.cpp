// Linear stages that the default algorithm needs for a true error, against a solution iterated to round-off:
//   linear_stages xml/bolted_joint.xml
// A stage that solves some of the load steps only counts as the part of a stage that it is. Exit code 1 when a number
// is above the table's.
#include <array>
#include <cstdio>
#include <iostream>
#include <limits>

#include <Tpetra_Core.hpp>

#include "Study.hpp"

namespace {

using namespace harmos;

constexpr std::array<double, 4> levels{1e-2, 1e-3, 1e-4, 1e-6};
constexpr int notKnown = 0;

/// The errors after every iteration of a run, with the linear stages spent so far.
struct Record {
  std::vector<int> stages;
  std::vector<double> curve, contact;
};

Record solve(const benchmarks::Study& study, const benchmarks::ConvergedSolution& reference, std::size_t response) {
  latin::LatinOptions options = study.options;
  options.accuracy = 1e-10;  // so that no certificate interrupts the iterations
  options.maximumIterations = 80;
  base::Timers timers;
  latin::LatinSolver solver(study.problem.assembly, options, Tpetra::getDefaultComm(), timers);
  for (const auto& one : study.problem.responses) solver.addResponse(one);
  Record record;
  solver.addObserver([&](const latin::IterationReport& report) {
    record.stages.push_back(report.linearStages);
    record.curve.push_back(reference.errorsOf(solver.state())[response]);
    record.contact.push_back(reference.contactForceError(solver.state()));
  });
  solver.solve();
  return record;
}

/// Stages after which the error stays below the level.
int stagesTo(double level, const std::vector<int>& stages, const std::vector<double>& errors) {
  std::size_t first = errors.size();
  while (first > 0 && errors[first - 1] <= level) --first;
  return first < errors.size() ? stages[first] : std::numeric_limits<int>::max();
}

/// One line of the table; true when no number is above `limits`.
bool print(const std::string& name, const Record& record, const std::vector<double>& errors,
           const std::array<int, 4>& limits) {
  bool isBelow = true;
  std::string measured, wanted;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int stages = stagesTo(levels[i], record.stages, errors);
    measured += (i > 0 ? " / " : "") + (stages < std::numeric_limits<int>::max() ? std::to_string(stages) : "-");
    wanted += (i > 0 ? " / " : "") + (limits[i] != notKnown ? std::to_string(limits[i]) : "-");
    isBelow = isBelow && (limits[i] == notKnown || stages <= limits[i]);
  }
  std::printf("| %s | %s | %s |\n", name.c_str(), measured.c_str(), wanted.c_str());
  std::fflush(stdout);
  return isBelow;
}

std::size_t positionOf(const std::string& response, const benchmarks::Study& study) {
  std::size_t i = 0;
  while (study.problem.responses[i]->name() != response) ++i;
  return i;
}

int measure(const std::vector<std::string>& arguments) {
  if (arguments.size() != 1) {
    std::cerr << "usage: linear_stages xml/bolted_joint.xml\n";
    return 2;
  }
  std::printf("| linear stages to a true error of 1e-2 / 1e-3 / 1e-4 / 1e-6 | measured | not above |\n|---|---|---|\n");
  bool isBelow = true;
  {
    const benchmarks::Study study(arguments[0], {});
    const benchmarks::ConvergedSolution reference(study);
    std::fprintf(stderr, "traction: residual of the reference %.1e\n", reference.residual());
    const Record record = solve(study, reference, positionOf("u_load", study));
    isBelow &= print("traction: curve", record, record.curve, {17, 21, 25, 41});
    isBelow &= print("traction: contact forces", record, record.contact, {15, 23, 31, 50});
  }
  {
    const benchmarks::Study study(arguments[0], benchmarks::displacementDriven());
    const benchmarks::ConvergedSolution reference(study);
    std::fprintf(stderr, "displacement-driven: residual of the reference %.1e\n", reference.residual());
    const Record record = solve(study, reference, positionOf("reaction", study));
    isBelow &= print("displacement-driven: reaction", record, record.curve, {22, 27, 33, notKnown});
    isBelow &= print("displacement-driven: contact forces", record, record.contact, {25, 32, 40, notKnown});
  }
  return isBelow ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return harmos::benchmarks::runProgram(argc, argv, measure);
}
