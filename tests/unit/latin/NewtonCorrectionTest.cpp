#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/NewtonCorrection.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// Two glued cubes under pressure: T is affine.
struct Glued {
  Glued()
      : cubes(twoCubes(laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 100.0}, {"Tangential Stiffness", 300.0}}),
                       laws::makeLaw("Pressure", {{"Pressure", 2.0}}, {{"Pressure", {1, -3}}}), 2)),
        fixedPoint(cubes.assembly(), {}, self(), timers),
        alpha(fixedPoint.layout().rows(), 2),
        image(fixedPoint.layout().rows(), 2) {}

  double residual(const base::Matrix& state) {
    base::Matrix r(state.numRows(), state.numCols());
    fixedPoint.apply(state, r);
    r -= state;
    return fixedPoint.metric().norm(r);
  }
  base::Matrix plus(const base::Matrix& step) const {
    base::Matrix sum(alpha);
    sum += step;
    return sum;
  }

  base::Timers timers;
  BoxAssembly cubes;
  FixedPoint fixedPoint;
  base::Matrix alpha, image;
};

// The difference quotient of an affine map is exact up to round-off 1e-16 over the relative step 1e-6.
TEST(NewtonCorrection, IsExactForAffineMaps) {
  Glued glued;
  randomize(glued.alpha);
  const double before = glued.residual(glued.alpha);
  const Iterate& iterate = glued.fixedPoint.apply(glued.alpha, glued.image);
  const auto result = NewtonCorrection(glued.fixedPoint).solve(iterate, glued.alpha, glued.image, 1e-9, 200);
  EXPECT_LE(result.reduction, 1e-9);
  EXPECT_GT(result.smallestSingularValue, 0.0);
  EXPECT_LT(glued.residual(glued.plus(result.step)), 1e-8 * before);
}

TEST(NewtonCorrection, SaysHowFarItReducedTheResidual) {
  Glued glued;
  randomize(glued.alpha);
  const double before = glued.residual(glued.alpha);
  double last = 1.0;
  for (int vectors : {1, 3, 6, 12}) {
    const Iterate& iterate = glued.fixedPoint.apply(glued.alpha, glued.image);
    const auto result = NewtonCorrection(glued.fixedPoint).solve(iterate, glued.alpha, glued.image, 0.0, vectors);
    EXPECT_EQ(result.vectors, vectors);
    EXPECT_LT(result.reduction, last);
    // For an affine map the linear residual is the residual of the corrected state.
    EXPECT_NEAR(glued.residual(glued.plus(result.step)) / before, result.reduction, 1e-6);
    last = result.reduction;
  }
}

TEST(NewtonCorrection, StopsAtTheTarget) {
  Glued glued;
  randomize(glued.alpha);
  const Iterate& iterate = glued.fixedPoint.apply(glued.alpha, glued.image);
  const auto result = NewtonCorrection(glued.fixedPoint).solve(iterate, glued.alpha, glued.image, 0.3, 200);
  EXPECT_LE(result.reduction, 0.3);
  EXPECT_LT(result.vectors, 60);
}

TEST(NewtonCorrection, StartsFromNothing) {
  Glued glued;
  const double before = glued.residual(glued.alpha);
  const Iterate& iterate = glued.fixedPoint.apply(glued.alpha, glued.image);
  const auto result = NewtonCorrection(glued.fixedPoint).solve(iterate, glued.alpha, glued.image, 1e-9, 200);
  EXPECT_LT(glued.residual(glued.plus(result.step)), 1e-8 * before);
}

TEST(NewtonCorrection, IsNothingAtAFixedPoint) {
  Glued glued;
  const Iterate& iterate = glued.fixedPoint.apply(glued.alpha, glued.image);
  const auto result = NewtonCorrection(glued.fixedPoint).solve(iterate, glued.alpha, glued.alpha, 0.1, 10);
  EXPECT_EQ(result.reduction, 0.0);
  EXPECT_EQ(result.vectors, 0);
  EXPECT_EQ(result.step.normInf(), 0.0);
}

}  // namespace
}  // namespace harmos::latin
