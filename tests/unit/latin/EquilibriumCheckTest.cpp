#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/EquilibriumCheck.hpp>
#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

Imbalance imbalanceOf(const std::shared_ptr<const laws::InterfaceLaw>& joint,
                      const std::shared_ptr<const laws::InterfaceLaw>& top, int iterations) {
  BoxAssembly cubes = twoCubes(joint, top, 2);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 2), image(fixedPoint.layout().rows(), 2);
  const Iterate* iterate = nullptr;
  for (int n = 0; n < iterations; ++n) {
    iterate = &fixedPoint.apply(alpha, image);
    for (int t = 0; t < 2; ++t) {
      for (int row = 0; row < alpha.numRows(); ++row) alpha(row, t) = 0.5 * (alpha(row, t) + image(row, t));
    }
  }
  return largestImbalance(*iterate);
}

std::shared_ptr<const laws::InterfaceLaw> push(double x, double z) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}, {"Z", z}}, {{"X", {0.5, 1.0}}});
}

// A frictionless joint carries nothing of a push along it: that push is the imbalance of the upper cube, at all times.
TEST(EquilibriumCheck, FindsTheLoadThatNothingCarries) {
  for (int iterations : {1, 5, 200}) {
    const Imbalance imbalance = imbalanceOf(laws::makeLaw("Unilateral Contact"), push(0.25, -2.0), iterations);
    EXPECT_EQ(imbalance.body, 1);
    EXPECT_EQ(imbalance.step, 1);
    EXPECT_NEAR(std::abs(imbalance.force[0]), 0.25, 1e-9);
    EXPECT_GT(imbalance.relative, 0.05);
  }
  const Imbalance settled = imbalanceOf(laws::makeLaw("Unilateral Contact"), push(0.25, -2.0), 200);
  EXPECT_NEAR(settled.force[1], 0.0, 1e-6);
  EXPECT_NEAR(settled.force[2], 0.0, 1e-3);
}

// Pulled off, the upper cube has no contact at all and still is the one that is carried away.
TEST(EquilibriumCheck, FindsABodyThatHasLostEveryContact) {
  const Imbalance imbalance = imbalanceOf(laws::makeLaw("Unilateral Contact"), push(0.0, 2.0), 200);
  EXPECT_EQ(imbalance.body, 1);
  EXPECT_NEAR(std::abs(imbalance.force[2]), 2.0, 1e-6);
}

// What two cubes that are bonded lack together does not depend on what the bond carries yet.
TEST(EquilibriumCheck, TakesBodiesTogetherThatMoveAsOne) {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                     {"middle", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}},
                     {"upper", {0, 0, 2}, {1, 1, 3}, {2, 2, 2}}});
  cubes.hold("bottom", "lower_zmin", clamp());
  cubes.join("contact", "lower_zmax", "middle_zmin", laws::makeLaw("Unilateral Contact"));
  cubes.join("bond", "middle_zmax", "upper_zmin", laws::makeLaw("Perfect"));
  cubes.hold("top", "upper_zmax", laws::makeLaw("Prescribed Traction", {{"X", 0.25}, {"Z", -2.0}}));
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  base::Matrix alpha(fixedPoint.layout().rows(), 1), image(alpha);
  for (int n = 0; n < 20; ++n) {
    const Iterate& iterate = fixedPoint.apply(alpha, image);
    if (n > 0) {
      const Imbalance together = largestImbalance(iterate, {-1, 0, 0});
      EXPECT_EQ(together.body, 1);
      EXPECT_NEAR(together.force[0], -0.25, 1e-9);
      for (std::size_t c = 0; c < 3; ++c) {
        const double middle = largestImbalance(iterate, {-1, 0, -1}).force[c];
        const double upper = largestImbalance(iterate, {-1, -1, 0}).force[c];
        EXPECT_NEAR(together.force[c], middle + upper, 1e-9);
      }
      EXPECT_EQ(largestImbalance(iterate, {-1, -1, -1}).body, -1);
    }
    image -= alpha;
    image.scale(0.5);
    alpha += image;
  }
}

TEST(EquilibriumCheck, FindsNothingWhereThereIsEquilibrium) {
  EXPECT_LT(imbalanceOf(laws::makeLaw("Perfect"), push(0.25, -2.0), 500).relative, 1e-6);
}

TEST(EquilibriumCheck, FindsNothingWithoutLoads) {
  const Imbalance imbalance = imbalanceOf(laws::makeLaw("Perfect"), push(0.0, 0.0), 3);
  EXPECT_EQ(imbalance.body, -1);
  EXPECT_EQ(imbalance.relative, 0.0);
}

TEST(EquilibriumCheck, NamesPartStepForceAndMoment) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Symmetry"));
  Imbalance imbalance;
  imbalance.body = 1;
  imbalance.step = 2;
  imbalance.force = {1.5, 0.0, -2.25};
  imbalance.moment = {0.0, 10.0, 0.0};
  const std::string text = describe(imbalance, cubes.assembly());
  for (const char* part : {"\"upper\"", "load step 3", "(1.5, 0, -2.25)", "(0, 10, 0)"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

}  // namespace
}  // namespace harmos::latin
