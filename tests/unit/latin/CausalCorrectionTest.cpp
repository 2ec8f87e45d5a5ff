#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/March.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/substructure/SolverFactory.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// Two cubes joined by a law and loaded from above, with a fixed point that can be asked for residuals.
struct Cubes {
  Cubes(const std::shared_ptr<const laws::InterfaceLaw>& joint, const std::shared_ptr<const laws::InterfaceLaw>& top,
        int stepCount, bool isConsistent = false, const StageOptions& options = {})
      : cubes(twoCubes(joint, top, stepCount, isConsistent)),
        steps(stepCount),
        fixedPoint(cubes.assembly(), options, self(), timers),
        alpha(fixedPoint.layout().rows(), steps),
        image(alpha) {}

  /// |T(alpha) - alpha| per load step, with all histories.
  std::vector<double> residuals(const base::Matrix& state) {
    base::Matrix r(state.numRows(), steps);
    fixedPoint.apply(state, r);
    r -= state;
    std::vector<double> norms = fixedPoint.metric().squaredNorms(r);
    for (double& value : norms) value = std::sqrt(value);
    return norms;
  }
  double residual(const base::Matrix& state) {
    const std::vector<double> norms = residuals(state);
    return *std::max_element(norms.begin(), norms.end());
  }
  CausalCorrection::Result correct(CausalCorrection& correction, double target, int stages) {
    const Iterate& iterate = fixedPoint.apply(alpha, image);
    return correction.correct(iterate, alpha, image, {target}, stages);
  }
  /// A state near the solution.
  void march(double tolerance) {
    March(fixedPoint, 30, tolerance, 0).run(alpha, tolerance, March::Guess::extrapolation);
  }

  base::Timers timers;
  BoxAssembly cubes;
  int steps;
  FixedPoint fixedPoint;
  base::Matrix alpha, image;
};

Cubes glued() {
  return {laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 100.0}, {"Tangential Stiffness", 300.0}}),
          laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", {1, -3}}}), 2};
}

/// Partial slip that goes on, turns and comes back.
Cubes rubbing(bool isConsistent = false, const StageOptions& options = {}) {
  return {laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
          laws::makeLaw("Prescribed Traction", {{"X", 0.9}, {"Z", -4.0}}, {{"X", {0, 0.5, 1, 0.2, -0.8}}}), 5,
          isConsistent, options};
}

TEST(CausalCorrection, IsExactForAffineMaps) {
  Cubes cubes = glued();
  randomize(cubes.alpha);
  const double before = cubes.residual(cubes.alpha);
  CausalCorrection correction(cubes.fixedPoint);
  const CausalCorrection::Result result = cubes.correct(correction, 1e-9, 300);
  EXPECT_LE(result.reduction, 1e-9);
  EXPECT_LT(cubes.residual(cubes.alpha), 2e-9 * before);
}

// What it says of the residual is what the laws say, all load steps one after the other.
TEST(CausalCorrection, KnowsTheTrueResidual) {
  for (const bool isConsistent : {false, true}) {
    Cubes cubes = rubbing(isConsistent);
    cubes.march(1e-2);
    const double before = cubes.residual(cubes.alpha);
    CausalCorrection correction(cubes.fixedPoint);
    for (const double target : {0.1, 0.3, 1e-4}) {
      const double start = cubes.residual(cubes.alpha);
      const CausalCorrection::Result result = cubes.correct(correction, target, 100);
      EXPECT_LE(result.reduction, target);
      EXPECT_LE(result.hidden, 0.5);
      EXPECT_NEAR(cubes.residual(cubes.alpha), result.reduction * start, 1e-6 * start);
    }
    EXPECT_LT(cubes.residual(cubes.alpha), 4e-6 * before);
  }
}

// Directions may be rough: what is said of the residual is what double precision finds.
TEST(CausalCorrection, KnowsTheTrueResidualOfDirectionsInSinglePrecision) {
  if (substructure::availableSolvers().front() != "cholmod") GTEST_SKIP() << "only CHOLMOD solves in single precision";
  StageOptions options;
  options.solver.invertTrace = true;
  Cubes cubes = rubbing(false, options);
  ASSERT_GT(cubes.fixedPoint.prepareSingle(), 1e-8);
  cubes.march(1e-2);
  CausalCorrection correction(cubes.fixedPoint, substructure::Precision::single);
  for (const double target : {0.1, 0.3, 1e-3}) {
    const double start = cubes.residual(cubes.alpha);
    const CausalCorrection::Result result = cubes.correct(correction, target, 100);
    // Double precision alone would leave the last application to the caller.
    ASSERT_NE(result.iterate, nullptr);
    EXPECT_LE(result.reduction, 1.25 * target);
    EXPECT_LE(result.hidden, 0.7);
    const double said = result.reduction * start;
    cubes.image -= cubes.alpha;
    const std::vector<double> squares = cubes.fixedPoint.metric().squaredNorms(cubes.image);
    EXPECT_NEAR(std::sqrt(*std::max_element(squares.begin(), squares.end())), said, 1e-9 * said);
    EXPECT_NEAR(cubes.residual(cubes.alpha), said, 1e-9 * said);
  }
}

// A way that was long tells an error that is too large; a hundredth of the residual is the end of it.
TEST(CausalCorrection, GoesFurtherWhereItsWayTellsALargerError) {
  const auto reductionFor = [](double error) {
    Cubes cubes = rubbing();
    cubes.march(1e-1);
    CausalCorrection correction(cubes.fixedPoint);
    const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
    return correction.correct(iterate, cubes.alpha, cubes.image, {0.1, error}, 100).reduction;
  };
  EXPECT_GT(reductionFor(1.0), 0.01);
  EXPECT_LE(reductionFor(1e-9), 0.01);
}

// The second time from the same place nothing is left to be solved.
TEST(CausalCorrection, KeepsItsDirections) {
  Cubes cubes = glued();
  randomize(cubes.alpha);
  const base::Matrix start(cubes.alpha);
  CausalCorrection correction(cubes.fixedPoint);
  const auto stages = [&] {
    cubes.alpha.assign(start);
    const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
    const int before = cubes.fixedPoint.linearStage().stages();
    EXPECT_LE(correction.correct(iterate, cubes.alpha, cubes.image, {1e-3}, 100).reduction, 1e-3);
    return cubes.fixedPoint.linearStage().stages() - before;
  };
  EXPECT_GT(stages(), 3);
  EXPECT_EQ(stages(), 0);
}

// Load steps that need nothing cost nothing.
TEST(CausalCorrection, SolvesOnlyTheLoadStepsThatAreLeft) {
  Cubes cubes = glued();
  CausalCorrection correction(cubes.fixedPoint);
  cubes.correct(correction, 1e-12, 300);
  const base::Matrix solved(cubes.alpha);
  const auto columnsFrom = [&](int firstWrong) {
    cubes.alpha.assign(solved);
    for (int t = firstWrong; t < cubes.steps; ++t) {
      for (int row = 0; row < solved.numRows(); ++row) cubes.alpha(row, t) += std::sin(row);
    }
    CausalCorrection fresh(cubes.fixedPoint);
    const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
    const long before = cubes.fixedPoint.linearStage().columns();
    EXPECT_LE(fresh.correct(iterate, cubes.alpha, cubes.image, {0.1}, 300).reduction, 0.1);
    return cubes.fixedPoint.linearStage().columns() - before;
  };
  const long both = columnsFrom(0);
  EXPECT_EQ(2 * columnsFrom(1), both);
}

// The error of a load step is told by its way, however small its residual is beside that of another one.
TEST(CausalCorrection, MovesEveryLoadStepThatTellsAnError) {
  Cubes cubes = glued();
  CausalCorrection correction(cubes.fixedPoint);
  cubes.correct(correction, 1e-12, 300);
  for (int row = 0; row < cubes.alpha.numRows(); ++row) {
    cubes.alpha(row, 0) += std::sin(row);
    cubes.alpha(row, 1) += 0.2 * std::sin(row);
  }
  const std::vector<double> before = cubes.residuals(cubes.alpha);
  ASSERT_LT(before[1], 0.3 * before[0]);
  CausalCorrection later(cubes.fixedPoint);
  CausalCorrection::Goal goal{0.3};
  goal.isLater = true;
  later.correct(cubes.fixedPoint.apply(cubes.alpha, cubes.image), cubes.alpha, cubes.image, goal, 300);
  const std::vector<double> after = cubes.residuals(cubes.alpha);
  for (int t = 0; t < cubes.steps; ++t) EXPECT_LE(after[t], 0.3 * before[t]) << t;
}

constexpr int manySteps = 2 * stepsAtOnce + 10;

std::vector<double> waves(int steps) {
  std::vector<double> factors;
  for (int t = 0; t < steps; ++t) factors.push_back(std::sin(0.3 * t));
  return factors;
}

/// Partial slip to and fro, so that every load step depends on many before it.
Cubes rubbingOften() {
  return {laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}}),
          laws::makeLaw("Prescribed Traction", {{"X", 0.9}, {"Z", -4.0}}, {{"X", waves(manySteps)}}), manySteps};
}

TEST(CausalCorrection, KnowsTheTrueResidualOfManyLoadSteps) {
  Cubes cubes = rubbingOften();
  cubes.march(1e-2);
  CausalCorrection correction(cubes.fixedPoint);
  for (const double target : {0.1, 0.3, 1e-3}) {
    const double start = cubes.residual(cubes.alpha);
    const CausalCorrection::Result result = cubes.correct(correction, target, 100);
    EXPECT_LE(result.reduction, target);
    EXPECT_LE(result.hidden, 0.5);
    EXPECT_NEAR(cubes.residual(cubes.alpha), result.reduction * start, 1e-6 * start);
  }
}

// Of many load steps directions would take memory without end: the second time they are found anew.
TEST(CausalCorrection, LetsGoOfTheDirectionsOfManyLoadSteps) {
  Cubes cubes(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 100.0}, {"Tangential Stiffness", 300.0}}),
              laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", waves(manySteps)}}), manySteps);
  randomize(cubes.alpha);
  const base::Matrix start(cubes.alpha);
  CausalCorrection correction(cubes.fixedPoint);
  const auto columns = [&] {
    cubes.alpha.assign(start);
    const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
    const long before = cubes.fixedPoint.linearStage().columns();
    EXPECT_LE(correction.correct(iterate, cubes.alpha, cubes.image, {1e-3}, 100).reduction, 1e-3);
    return cubes.fixedPoint.linearStage().columns() - before;
  };
  const long first = columns();
  EXPECT_GT(first, 3 * manySteps);
  EXPECT_GE(columns(), first);
}

// Where modes are soft, new directions would tell another least singular value: as many as a window has are kept.
TEST(CausalCorrection, KeepsTheDirectionsOfTheSoftestOfManyLoadSteps) {
  const auto columnsOfSecond = [](double stiffness) {
    Cubes cubes(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", stiffness}, {"Tangential Stiffness", stiffness}}),
                laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", waves(manySteps)}}), manySteps);
    randomize(cubes.alpha);
    const base::Matrix start(cubes.alpha);
    CausalCorrection correction(cubes.fixedPoint);
    std::vector<long> columns;
    for (int i = 0; i < 2; ++i) {
      cubes.alpha.assign(start);
      const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
      const long before = cubes.fixedPoint.linearStage().columns();
      EXPECT_LE(correction.correct(iterate, cubes.alpha, cubes.image, {1e-3}, 100).reduction, 1e-3);
      columns.push_back(cubes.fixedPoint.linearStage().columns() - before);
    }
    return static_cast<double>(columns[1]) / static_cast<double>(columns[0]);
  };
  EXPECT_GE(columnsOfSecond(300.0), 1.0);
  const double others = static_cast<double>(manySteps - stepsAtOnce) / manySteps;
  EXPECT_NEAR(columnsOfSecond(0.1), others, 0.1);
}

TEST(CausalCorrection, IsNothingAtAFixedPoint) {
  Cubes cubes = glued();
  CausalCorrection correction(cubes.fixedPoint);
  cubes.correct(correction, 1e-15, 300);
  const int before = cubes.fixedPoint.linearStage().stages();
  const base::Matrix state(cubes.alpha);
  const CausalCorrection::Result result = cubes.correct(correction, 0.1, 300);
  EXPECT_LE(cubes.fixedPoint.linearStage().stages() - before, 3);
  for (int t = 0; t < cubes.steps; ++t) {
    for (int row = 0; row < state.numRows(); ++row) EXPECT_NEAR(cubes.alpha[t][row], state[t][row], 1e-10);
  }
  EXPECT_LE(result.hidden, 1.0);
}

TEST(CausalCorrection, StaysWithinItsStages) {
  Cubes cubes = rubbing();
  cubes.march(1e-1);
  CausalCorrection correction(cubes.fixedPoint);
  const double before = cubes.residual(cubes.alpha);
  const Iterate& iterate = cubes.fixedPoint.apply(cubes.alpha, cubes.image);
  const int stages = cubes.fixedPoint.linearStage().stages();
  const CausalCorrection::Result result = correction.correct(iterate, cubes.alpha, cubes.image, {1e-9}, 3);
  EXPECT_LE(cubes.fixedPoint.linearStage().stages() - stages, 3);
  EXPECT_GT(result.reduction, 1e-9);
  EXPECT_NEAR(cubes.residual(cubes.alpha), result.reduction * before, 1e-6 * before);
}

}  // namespace
}  // namespace harmos::latin
