// Glue that softens between two chains, of a stiffness of 20/3 together, pulled apart at their end.
#include <gtest/gtest.h>

#include <harmos/latin/March.hpp>
#include <harmos/latin/StepContinuation.hpp>

#include "Chains.hpp"

namespace harmos::latin {
namespace {

constexpr double stiffness = 20.0 / 3.0, onset = 1e-3, target = 1e-10;

std::shared_ptr<const laws::InterfaceLaw> pulled(const std::string& how, const std::vector<double>& sizes) {
  return laws::makeLaw("Prescribed " + how, {{"X", 1.0}, {"Y", 0.0}, {"Z", 0.0}}, {{"X", sizes}});
}

struct PulledGlue {
  PulledGlue(double fall, const std::string& how, const std::vector<double>& sizes)
      : assembly(twoChains(softGlue(fall), pulled(how, sizes), static_cast<int>(sizes.size()))),
        fixedPoint(assembly, {}, self(), timers),
        newton(fixedPoint) {}

  /// The traction of the glue at a state of one load step that is selected.
  double traction(const base::Matrix& state) {
    base::Matrix image(state.numRows(), state.numCols());
    fixedPoint.apply(state, image);
    return fixedPoint.pointwiseStage().states(1)[0].traction[0];
  }

  base::Timers timers;
  assembly::Assembly assembly;
  FixedPoint fixedPoint;
  StepNewton newton;
};

/// Of glue that has been opened to a displacement u of the end, on its falling branch.
double fallingTraction(double fall, double u) {
  const double opening = (u - (1.0 + fall * onset) / stiffness) / (1.0 - fall / stiffness);
  return 1.0 - fall * (opening - onset);
}

TEST(StepContinuation, LeadsAcrossThePeakWhereThePathGoesOn) {
  PulledGlue glue(3.0, "Displacement", {0.25});
  glue.fixedPoint.select({0});
  const int rows = glue.fixedPoint.layout().rows();
  base::Matrix state(rows, 1);
  const StepContinuation::Result result =
      StepContinuation(glue.fixedPoint, glue.newton).solve(0, base::Matrix(rows, 1), {}, state, target, 0.0, {});
  EXPECT_TRUE(result.isReached);
  EXPECT_EQ(result.share, 1.0);
  EXPECT_NEAR(glue.traction(state), fallingTraction(3.0, 0.25), 1e-8);
}

// Beyond half of the force nothing holds: the last part ends just below.
TEST(StepContinuation, EndsWhereTheGlueSnaps) {
  PulledGlue glue(3.0, "Traction", {2.0});
  glue.fixedPoint.select({0});
  const int rows = glue.fixedPoint.layout().rows();
  base::Matrix state(rows, 1);
  const StepContinuation::Result result =
      StepContinuation(glue.fixedPoint, glue.newton).solve(0, base::Matrix(rows, 1), {}, state, target, 0.0, {});
  EXPECT_FALSE(result.isReached);
  EXPECT_GE(result.parts, 2);
  EXPECT_NEAR(result.share, 0.5, 2.0 * StepContinuation::leastPart);
  EXPECT_LE(result.share, 0.5);
}

// It falls by more than the chains spring back by: beyond u = 0.151 nothing but the broken glue is in equilibrium.
TEST(StepNewton, SettlesWhereGlueThatSnapsComesToRest) {
  PulledGlue glue(10.0, "Displacement", {0.2});
  glue.fixedPoint.select({0});
  const int rows = glue.fixedPoint.layout().rows();
  base::Matrix state(rows, 1), beta(rows, 1);
  const StepContinuation::Result result =
      StepContinuation(glue.fixedPoint, glue.newton).solve(0, base::Matrix(rows, 1), {}, state, target, 0.0, {});
  ASSERT_FALSE(result.isReached);
  glue.fixedPoint.solveLinear(state, beta);
  EXPECT_TRUE(glue.newton.settle(state, beta, target, {}).isReached);
  EXPECT_NEAR(glue.traction(state), 0.0, 1e-8);
}

// Nothing is at rest under a force that has broken it, and the state is that of before.
TEST(StepNewton, DoesNotSettleUnderAForceThatNothingHolds) {
  PulledGlue glue(10.0, "Traction", {2.0});
  glue.fixedPoint.select({0});
  const int rows = glue.fixedPoint.layout().rows();
  base::Matrix state(rows, 1), beta(rows, 1);
  glue.fixedPoint.solveLinear(state, beta);
  EXPECT_FALSE(glue.newton.settle(state, beta, target, {}).isReached);
  for (int row = 0; row < rows; ++row) EXPECT_EQ(state(row, 0), 0.0);
}

TEST(StepContinuation, StopsWhenAsked) {
  PulledGlue glue(3.0, "Displacement", {0.25});
  glue.fixedPoint.select({0});
  const int rows = glue.fixedPoint.layout().rows();
  base::Matrix state(rows, 1);
  EXPECT_FALSE(StepContinuation(glue.fixedPoint, glue.newton)
                   .solve(0, base::Matrix(rows, 1), {}, state, target, 0.0, [] { return true; })
                   .isReached);
  base::Matrix beta(rows, 1);
  glue.fixedPoint.solveLinear(state, beta);
  EXPECT_FALSE(glue.newton.settle(state, beta, target, [] { return true; }).isReached);
}

// The march goes along the falling branch and back towards the origin, with the damage that it has done.
TEST(StepContinuation, HelpsTheMarch) {
  PulledGlue glue(3.0, "Displacement", {0.1, 0.2, 0.3, 0.15});
  base::Matrix alpha(glue.fixedPoint.layout().rows(), 4);
  March march(glue.fixedPoint, 30, 1e-3, 0);
  march.setNewton(glue.newton);
  ASSERT_EQ(march.run(alpha, 1e-9, March::Guess::extrapolation), March::End::reached);
  glue.traction(alpha);
  const auto& states = glue.fixedPoint.pointwiseStage().states(1);
  const double peak = fallingTraction(3.0, 0.3), opening = 0.3 - peak / stiffness, secant = peak / opening;
  EXPECT_NEAR(states[0].traction[0], 0.1 / (1.0 / stiffness + onset), 1e-7);
  EXPECT_NEAR(states[1].traction[0], fallingTraction(3.0, 0.2), 1e-7);
  EXPECT_NEAR(states[2].traction[0], peak, 1e-7);
  EXPECT_NEAR(states[3].traction[0], 0.15 / (1.0 / stiffness + 1.0 / secant), 1e-7);
}

}  // namespace
}  // namespace harmos::latin
