#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/March.hpp>
#include <harmos/latin/StepNewton.hpp>
#include <harmos/latin/StepwiseCorrection.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

Law friction() {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", 0.3}});
}

/// Two cubes joined by a law and loaded from above.
struct Cubes {
  Cubes(const Law& joint, const Law& top, int stepCount)
      : cubes(twoCubes(joint, top, stepCount)),
        steps(stepCount),
        fixedPoint(cubes.assembly(), {}, self(), timers),
        newton(fixedPoint) {}

  int rows() const { return fixedPoint.layout().rows(); }
  long columns() const { return fixedPoint.linearStage().columns(); }

  /// Solves the first load steps in turn from a state of all zeros, each to |R| <= target, by Newton's method or in
  /// pseudo-time, and returns |R| of the last one as an iteration finds it.
  double solve(int count, double target, bool inPseudoTime = false) {
    fixedPoint.startUnloaded();
    double size = 0.0;
    for (int t = 0; t < count; ++t) {
      fixedPoint.select({t});
      state.shape(rows(), 1);
      base::Matrix image(rows(), 1);
      const base::Matrix beta(fixedPoint.apply(state, image).beta());
      const long before = columns();
      result = inPseudoTime ? newton.settle(state, beta, target, {}) : newton.solve(state, beta, target, {});
      solved = columns() - before;
      fixedPoint.apply(state, image);
      fixedPoint.startFromHere();
      size = fixedPoint.metric().distance(state, image);
    }
    fixedPoint.startUnloaded();
    fixedPoint.selectAll();
    return size;
  }

  base::Timers timers;
  BoxAssembly cubes;
  int steps;
  FixedPoint fixedPoint;
  StepNewton newton;
  StepNewton::Result result;
  base::Matrix state;
  long solved = 0;  // columns of the last load step
};

Cubes glued() {
  return {laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 100.0}, {"Tangential Stiffness", 300.0}}),
          laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", {1, -3}}}), 2};
}

/// Pressed, and dragged to and fro.
Cubes rubbing() {
  return {friction(), laws::makeLaw("Prescribed Traction", {{"X", 0.9}, {"Z", -4.0}}, {{"X", {0, 0.5, 1, 0.2, -0.8}}}),
          5};
}

TEST(StepNewton, SolvesAffineLawsInOneGo) {
  Cubes cubes = glued();
  EXPECT_LE(cubes.solve(1, 1e-9), 1e-9);
  EXPECT_TRUE(cubes.result.isReached);
  EXPECT_LE(cubes.result.residual, 1e-9);
  EXPECT_GT(cubes.result.smallestSingularValue, 0.0);
}

// The second load step is three times the first one, turned round: all its directions are known.
TEST(StepNewton, KeepsItsDirections) {
  Cubes cubes = glued();
  EXPECT_FALSE(cubes.newton.isUsed());
  cubes.solve(1, 1e-9);
  EXPECT_GT(cubes.solved, 5);
  EXPECT_TRUE(cubes.newton.isUsed());
  EXPECT_LE(cubes.solve(2, 1e-7), 1e-7);
  EXPECT_EQ(cubes.solved, 0);
  // Images belong to one search direction.
  cubes.fixedPoint.rescale(0.1);
  EXPECT_FALSE(cubes.newton.isUsed());
  EXPECT_LE(cubes.solve(1, 1e-9), 1e-9);
  EXPECT_GT(cubes.solved, 5);
}

TEST(StepNewton, FollowsTheHistoryOfFriction) {
  Cubes cubes = rubbing();
  EXPECT_LE(cubes.solve(cubes.steps, 1e-9), 1e-9);
  base::Matrix alpha(cubes.rows(), cubes.steps), image(alpha);
  ASSERT_EQ(March(cubes.fixedPoint, 30, 1e-3, 0).run(alpha, 1e-11, March::Guess::extrapolation), March::End::reached);
  for (int row = 0; row < cubes.rows(); ++row) EXPECT_NEAR(cubes.state[0][row], alpha[cubes.steps - 1][row], 1e-5);
}

TEST(StepNewton, ComesInPseudoTimeToWhatNewtonsMethodFinds) {
  Cubes one = rubbing(), other = rubbing();
  EXPECT_LE(one.solve(one.steps, 1e-9), 1e-9);
  // What many small steps have added up to is a little rougher than the image that an iteration finds anew.
  EXPECT_LE(other.solve(other.steps, 1e-9, true), 1e-8);
  EXPECT_TRUE(other.result.isReached);
  EXPECT_FALSE(other.result.slide);
  for (int row = 0; row < one.rows(); ++row) EXPECT_NEAR(other.state[0][row], one.state[0][row], 1e-7);
}

// A cube that is pulled off flies for ever: soon no more is tried, the state is as it was, and it is seen to fly on.
TEST(StepNewton, GivesUpInPseudoTimeWhereNothingHolds) {
  Cubes cubes(laws::makeLaw("Unilateral Contact"), laws::makeLaw("Pressure", {{"Pressure", -2.0}}), 1);
  EXPECT_GT(cubes.solve(1, 1e-7, true), 1e-3);
  EXPECT_FALSE(cubes.result.isReached);
  EXPECT_LE(cubes.solved, 60);
  ASSERT_TRUE(cubes.result.slide);
  EXPECT_GT(cubes.fixedPoint.metric().norm(*cubes.result.slide), 1e5);
  for (int row = 0; row < cubes.rows(); ++row) EXPECT_EQ(cubes.state[0][row], 0.0);
}

// Glue so much stiffer than the cubes that no state is near that of the load step before.
TEST(StepNewton, GivesUpInPseudoTimeBeforeItsTangentOverflows) {
  for (const double stiffness : {1e6, 1e8, 1e10, 1e11}) {
    const Law glue = laws::makeLaw("Cohesive Zone", {{"Stiffness", stiffness},
                                                     {"Normal Strength", 1.0},
                                                     {"Shear Strength", 1.0},
                                                     {"Mode I Fracture Energy", 0.005},
                                                     {"Mode II Fracture Energy", 0.005}});
    const Law drawn =
        laws::makeLaw("Prescribed Displacement", {{"X", 0.0}, {"Y", 0.0}, {"Z", 1.0}}, {{"Z", {0.006, 0.009}}});
    base::Timers timers;
    LatinOptions options;
    options.accuracy = 1e-6;
    BoxAssembly cubes = twoCubes(glue, drawn, 2);
    LatinSolver solver(cubes.assembly(), options, self(), timers);
    LatinResult result;
    EXPECT_NO_THROW(result = solver.solve()) << stiffness;
    EXPECT_FALSE(result.reason.empty()) << stiffness;
  }
}

// The gap closes after a way that the tangents of an open contact know nothing of, and has no scale of the cubes.
TEST(StepNewton, FollowsABodyThatNothingHoldsUntilItIsStopped) {
  for (const double gap : {1e-3, 1.0, 1e3}) {
    Cubes cubes(laws::makeLaw("Unilateral Contact", {{"Gap", gap}}), laws::makeLaw("Pressure", {{"Pressure", 2.0}}), 1);
    const double size = cubes.solve(1, 1e-7);
    EXPECT_TRUE(cubes.result.isReached) << gap;
    EXPECT_LE(size, 1e-6 * (1.0 + gap)) << gap;
  }
}

// They answer so little that the way is a hundred million times what the residual says.
TEST(StepNewton, KnowsTheWayOfABodyThatHangsOnSoftSprings) {
  Cubes cubes(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 1e-7}, {"Tangential Stiffness", 1e-7}}),
              laws::makeLaw("Pressure", {{"Pressure", -2.0}}), 1);
  const double size = cubes.solve(1, 1e-4);
  EXPECT_TRUE(cubes.result.isReached);
  EXPECT_LE(size, 1e-4);
  EXPECT_LT(cubes.result.smallestSingularValue, 1e-8);
  EXPECT_LE(cubes.solved, 20);
}

TEST(StepNewton, LeavesTheStateWhereItCannotSolve) {
  Cubes cubes(laws::makeLaw("Unilateral Contact"), laws::makeLaw("Pressure", {{"Pressure", -2.0}}), 1);
  EXPECT_GT(cubes.solve(1, 1e-7), 1e-3);
  EXPECT_FALSE(cubes.result.isReached);
  for (int row = 0; row < cubes.rows(); ++row) EXPECT_EQ(cubes.state[0][row], 0.0);
}

TEST(StepNewton, StopsWhenItMust) {
  Cubes cubes = rubbing();
  cubes.fixedPoint.select({0});
  base::Matrix state(cubes.rows(), 1), image(state);
  const base::Matrix beta(cubes.fixedPoint.apply(state, image).beta());
  const long before = cubes.columns();
  EXPECT_FALSE(cubes.newton.solve(state, beta, 1e-9, [] { return true; }).isReached);
  EXPECT_EQ(cubes.columns(), before);
}

/// |T(alpha) - alpha| of every load step, with all histories.
std::vector<double> residuals(Cubes& cubes, const base::Matrix& alpha) {
  base::Matrix r(alpha.numRows(), cubes.steps);
  cubes.fixedPoint.apply(alpha, r);
  r -= alpha;
  std::vector<double> norms = cubes.fixedPoint.metric().squaredNorms(r);
  for (double& norm : norms) norm = std::sqrt(norm);
  return norms;
}

double residual(Cubes& cubes, const base::Matrix& alpha) {
  const std::vector<double> norms = residuals(cubes, alpha);
  return *std::max_element(norms.begin(), norms.end());
}

TEST(StepwiseCorrection, BringsAllLoadStepsToTheTarget) {
  Cubes cubes = rubbing();
  base::Matrix alpha(cubes.rows(), cubes.steps), image(alpha);
  March(cubes.fixedPoint, 30, 1e-1, 0).run(alpha, 1e-1, March::Guess::extrapolation);
  StepwiseCorrection correction(cubes.fixedPoint, cubes.newton);
  const double start = residual(cubes, alpha);
  for (const double target : {0.1 * start, 1e-3 * start, 1e-7 * start}) {
    const Iterate& iterate = cubes.fixedPoint.apply(alpha, image);
    const StepwiseCorrection::Result result =
        correction.correct(iterate, alpha, target, std::vector<double>(cubes.steps, target), 1000);
    EXPECT_TRUE(result.isReached);
    EXPECT_GT(result.smallestSingularValue, 0.0);
    EXPECT_LE(residual(cubes, alpha), 1.01 * target);
  }
}

// An error at one load step shows in a residual that may be small beside those of the others.
TEST(StepwiseCorrection, MovesEveryLoadStep) {
  Cubes cubes = rubbing();
  base::Matrix alpha(cubes.rows(), cubes.steps), image(alpha);
  March(cubes.fixedPoint, 30, 1e-1, 0).run(alpha, 1e-1, March::Guess::extrapolation);
  const std::vector<double> before = residuals(cubes, alpha);
  std::vector<double> targets = before;
  for (double& target : targets) target *= 1e-3;
  StepwiseCorrection correction(cubes.fixedPoint, cubes.newton);
  EXPECT_TRUE(correction.correct(cubes.fixedPoint.apply(alpha, image), alpha, before[0], targets, 1000).isReached);
  const std::vector<double> after = residuals(cubes, alpha);
  for (int t = 0; t < cubes.steps; ++t) EXPECT_LE(after[t], 1.01 * targets[t] + 1e-13 * before[t]) << t;
}

TEST(StepwiseCorrection, StaysWithinItsStages) {
  Cubes cubes = rubbing();
  base::Matrix alpha(cubes.rows(), cubes.steps), image(alpha);
  StepwiseCorrection correction(cubes.fixedPoint, cubes.newton);
  const Iterate& iterate = cubes.fixedPoint.apply(alpha, image);
  const int stages = cubes.fixedPoint.linearStage().stages();
  EXPECT_FALSE(correction.correct(iterate, alpha, 1e-9, std::vector<double>(cubes.steps, 1e-9), stages).isReached);
  EXPECT_EQ(cubes.fixedPoint.linearStage().stages(), stages);
}

}  // namespace
}  // namespace harmos::latin
