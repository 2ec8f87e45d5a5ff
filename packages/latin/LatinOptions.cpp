#include <harmos/latin/LatinOptions.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::latin {
namespace {

// Of the accuracy, where operators are solved iteratively; below the second round-off ends iterations.
constexpr double shareOfIterations = 1e-6, finestIterations = 1e-12;

}  // namespace

void LatinOptions::describe(input::ParameterSpec& spec) {
  const LatinOptions defaults;
  spec.summary("The LATIN solver. Only the accuracy should need a thought.");
  spec.number("Accuracy")
      .unit("-")
      .defaultValue(defaults.accuracy)
      .atLeast(1e-10)
      .atMost(3e-2)
      .doc(
          "Largest relative error of every response and of the fields of interface forces and displacements. The run "
          "stops "
          "when its error estimate is below; otherwise it says that it is not.");
  spec.text("Formulation")
      .defaultValue("Displacement")
      .oneOf({"Displacement", "Velocity"})
      .doc(
          "Kinematic unknown of the interfaces: displacements, all time steps at once, or velocities, step after "
          "step.");
  spec.text("Algorithm")
      .defaultValue("Default")
      .oneOf({"Default", "Plain", "Relaxed"})
      .doc("Default: Anderson acceleration per time step. Plain and Relaxed: the iterations of the literature.");
  spec.number("Relaxation")
      .unit("-")
      .defaultValue(defaults.relaxation)
      .above(0.0)
      .atMost(1.0)
      .doc("Of the algorithm Relaxed.");
  spec.integer("Maximum Iterations")
      .defaultValue(defaults.maximumIterations)
      .atLeast(1)
      .doc("Linear stages after which the run stops without a certificate.");
  spec.flag("Macro Problem")
      .optional()
      .doc("Balance the resultants of every interface in the linear stage. Absent: only with the algorithm Default.");
  input::ParameterSpec& search = spec.list("Search Direction");
  search.summary("The parameter k of the search directions, found automatically at every node.");
  search.number("Scale")
      .unit("-")
      .defaultValue(defaults.stages.searchDirectionScale)
      .atLeast(1e-9)
      .atMost(1e9)
      .doc("Multiplies the automatic value.");
  input::ParameterSpec& acceleration = spec.list("Acceleration");
  acceleration.summary("Anderson acceleration.");
  acceleration.integer("Memory")
      .defaultValue(defaults.memory)
      .atLeast(1)
      .atMost(1000)
      .doc("Iterations remembered; 10 when memory is short.");
  input::ParameterSpec& solver = spec.list("Linear Solver");
  solver.summary("Direct solver that factors the substructures.");
  substructure::SolverOptions::describe(solver);
}

LatinOptions::LatinOptions(const input::Parameters& parameters)
    : accuracy(parameters.number("Accuracy")),
      maximumIterations(parameters.integer("Maximum Iterations")),
      relaxation(parameters.number("Relaxation")),
      memory(parameters.list("Acceleration").integer("Memory")) {
  const std::string& name = parameters.text("Algorithm");
  algorithm = name == "Plain" ? Algorithm::plain : name == "Relaxed" ? Algorithm::relaxed : Algorithm::accelerated;
  stages.formulation = parameters.text("Formulation") == "Velocity" ? Formulation::velocity : Formulation::displacement;
  stages.searchDirectionScale = parameters.list("Search Direction").number("Scale");
  stages.macroProblem =
      parameters.has("Macro Problem") ? parameters.flag("Macro Problem") : algorithm == Algorithm::accelerated;
  if (algorithm != Algorithm::accelerated) stages.elimination = Elimination::none;
  stages.solver = substructure::SolverOptions(parameters.list("Linear Solver"));
  stages.solver.iterationTolerance =
      std::clamp(shareOfIterations * accuracy, finestIterations, stages.solver.iterationTolerance);
}

const LatinOptions& demandValid(const LatinOptions& options) {
  const auto demand = [](bool isRight, const std::string& what) {
    if (!isRight) throw base::Error("the options of the solver cannot be used: " + what, base::ExitCode::input);
  };
  demand(options.accuracy > 0.0 && options.accuracy < 1.0,
         "accuracy is " + base::toText(options.accuracy) + "; take one above 0 and below 1");
  demand(options.maximumIterations >= 1,
         "maximumIterations is " + std::to_string(options.maximumIterations) + "; take 1 at least");
  demand(options.memory >= 1, "memory is " + std::to_string(options.memory) + "; take 1 at least");
  demand(options.restarts >= 0, "restarts is " + std::to_string(options.restarts) + "; take 0 at least");
  demand(options.relaxation > 0.0 && options.relaxation <= 1.0,
         "relaxation is " + base::toText(options.relaxation) + "; take one above 0 and at most 1");
  const double scale = options.stages.searchDirectionScale;
  demand(scale > 0.0 && std::isfinite(scale), "searchDirectionScale is " + base::toText(scale) + "; take one above 0");
  return options;
}

}  // namespace harmos::latin
