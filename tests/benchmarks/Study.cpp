#include "Study.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

#include <Tpetra_Core.hpp>

#include <harmos/base/BlasKernels.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>

namespace harmos::benchmarks {

Overrides displacementDriven() {
  return {"Boundaries/loaded/Law/Type=Prescribed Displacement", "Boundaries/loaded/Law/X=0.5", "Values/mu=0.25",
          "Values/preload_1=0.1", "Values/preload_2=0.1"};
}

double optionOf(std::vector<std::string>& arguments, const std::string& option, double fallback) {
  const auto found = std::find(arguments.begin(), arguments.end(), option);
  if (found == arguments.end()) return fallback;
  if (found + 1 == arguments.end()) throw base::Error(option + " needs a number.", base::ExitCode::input);
  const double value = std::stod(*(found + 1));
  arguments.erase(found, found + 2);
  return value;
}

int runProgram(int argc, char** argv, const std::function<int(std::vector<std::string>)>& program) {
  base::useFittingBlas(argv);
  Tpetra::ScopeGuard scope(&argc, &argv);
  try {
    return program({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << "\n";
    return 1;
  }
}

Study::Study(const std::string& path, const Overrides& overrides)
    : scene(scene::readScene(path, overrides, laws::builtInLaws())),
      problem(make(scene)),
      options(scene.input.list("Solver")) {}

scene::Problem Study::make(const scene::Scene& scene) {
  base::Timers timers;
  return scene::makeProblem(scene, *Tpetra::getDefaultComm(), timers);
}

ConvergedSolution::ConvergedSolution(const Study& study)
    : study_(study), fixedPoint_(study.problem.assembly, study.options.stages, Tpetra::getDefaultComm(), timers_) {
  constexpr double target = 1e-11;
  constexpr int maximumIterations = 600;
  const latin::StateMetric& metric = fixedPoint_.metric();
  base::Matrix alpha(fixedPoint_.layout().rows(), study.problem.assembly.steps());
  base::Matrix image(alpha), residual(alpha);
  latin::AndersonAcceleration acceleration(metric, study.options.memory);
  for (int i = 0; i < maximumIterations && residual_ > target; ++i) {
    iterate_ = &fixedPoint_.apply(alpha, image);
    residual.assign(image);
    residual -= alpha;
    residual_ = metric.norm(residual) / metric.norm(image);
    acceleration.advance(alpha, image);
  }
  snapshot_ = std::make_unique<latin::Snapshot>(*iterate_, study.problem.responses);
}

std::vector<double> ConvergedSolution::errorsOf(const latin::Iterate& state) const {
  return snapshot_->distance(latin::Snapshot(state, study_.problem.responses));
}

double ConvergedSolution::contactForceError(const latin::Iterate& state) const {
  const latin::TraceLayout& layout = fixedPoint_.layout();
  double largestError = 0.0;
  double largest = 0.0;
  for (int t = 0; t < study_.problem.assembly.steps(); ++t) {
    double error = 0.0;
    double size = 0.0;
    for (const latin::TraceLayout::Block& block : layout.blocks()) {
      const assembly::Interface& interface = study_.problem.assembly.interfaces[block.interface];
      if (!interface.law->dissipates()) continue;
      for (int row = block.begin; row < block.begin + layout.dimension() * block.pairs; ++row) {
        const double f = iterate_->hattedTraction()[t][row];
        const double difference = state.hattedTraction()[t][row] - f;
        const double area = layout.area()[row];
        error += area * difference * difference;
        size += area * f * f;
      }
    }
    largestError = std::max(largestError, error);
    largest = std::max(largest, size);
  }
  return largest > 0.0 ? std::sqrt(largestError / largest) : 0.0;
}

}  // namespace harmos::benchmarks
