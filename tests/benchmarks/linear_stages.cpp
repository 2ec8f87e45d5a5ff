// Linear stages that the default algorithm needs for a true error, against a solution iterated to round-off:
//   linear_stages xml/bolted_joint.xml
// A stage that solves some of the load steps only counts as the part of a stage that it is; certificates are not
// counted. Exit code 1 when a number is above the table's.
#include <array>
#include <cstdio>
#include <iostream>
#include <limits>

#include <Tpetra_Core.hpp>

#include <harmos/latin/March.hpp>

#include "Study.hpp"

namespace {

using namespace harmos;

constexpr std::array<double, 4> levels{1e-2, 1e-3, 1e-4, 1e-6};
constexpr int notKnown = 0;

/// The errors after marches to ever smaller residuals, each from rest, with the linear stages that each took.
struct Record {
  std::vector<int> stages;
  std::vector<double> curve, contact;
};

Record solve(const benchmarks::Study& study, const benchmarks::ConvergedSolution& reference, std::size_t response) {
  base::Timers timers;
  latin::FixedPoint fixedPoint(study.problem.assembly, study.options.stages, Tpetra::getDefaultComm(), timers);
  Record record;
  for (double tolerance = 3e-2; tolerance > 1e-8; tolerance /= 1.5) {
    base::Matrix alpha(fixedPoint.layout().rows(), study.problem.assembly.steps());
    base::Matrix image(alpha);
    const int before = fixedPoint.linearStage().stages();
    latin::March march(fixedPoint, study.options.memory, study.options.accuracy, study.options.restarts);
    march.run(alpha, tolerance, latin::March::Guess::extrapolation);
    record.stages.push_back(fixedPoint.linearStage().stages() - before);
    const latin::Iterate& iterate = fixedPoint.apply(alpha, image);
    record.curve.push_back(reference.errorsOf(iterate)[response]);
    record.contact.push_back(reference.contactForceError(iterate));
  }
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
