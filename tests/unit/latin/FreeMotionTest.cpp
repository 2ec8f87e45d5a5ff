#include <gtest/gtest.h>

#include <harmos/latin/FreeMotion.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

using Law = std::shared_ptr<const laws::InterfaceLaw>;

Law frictionless() {
  return laws::makeLaw("Unilateral Contact");
}
Law friction(double mu) {
  return laws::makeLaw("Coulomb Friction", {{"Friction Coefficient", mu}});
}
Law push(double x, double z) {
  return laws::makeLaw("Prescribed Traction", {{"X", x}, {"Z", z}});
}
Law springs(double stiffness) {
  return laws::makeLaw("Elastic Foundation", {{"Normal Stiffness", stiffness}});
}

/// What is found at the body that lacks most after some relaxed iterations.
struct Finding {
  Finding(BoxAssembly cubes, int iterations, double scale = 1.0) : cubes_(std::move(cubes)) {
    StageOptions options;
    options.searchDirectionScale = scale;
    base::Timers timers;
    FixedPoint fixedPoint(cubes_.assembly(), options, self(), timers);
    const int rows = fixedPoint.layout().rows(), steps = cubes_.assembly().steps();
    base::Matrix alpha(rows, steps), image(rows, steps);
    for (int n = 0; n < iterations; ++n) {
      fixedPoint.apply(alpha, image);
      for (int t = 0; t < steps; ++t) {
        for (int row = 0; row < rows; ++row) alpha(row, t) = 0.5 * (alpha(row, t) + image(row, t));
      }
    }
    const Iterate& iterate = fixedPoint.apply(alpha, image);
    imbalance = largestImbalance(iterate);
    const base::Matrix before(image), forces(iterate.hattedTraction());
    const FreeMotion motion = followImbalance(imbalance, {}, fixedPoint, iterate, alpha, image);
    isFree = motion.isFree;
    for (int t = 0; t < steps; ++t) {
      for (int row = 0; row < rows; ++row) {
        EXPECT_EQ(image(row, t), before(row, t));
        EXPECT_EQ(motion.iterate->hattedTraction()(row, t), forces(row, t));
      }
    }
    hasLanded = motion.landing.has_value();
    if (!hasLanded) return;
    afterLanding = largestImbalance(fixedPoint.apply(*motion.landing, image));
  }

  Imbalance imbalance, afterLanding;
  bool hasLanded = false;
  bool isFree = false;

 private:
  BoxAssembly cubes_;
};

constexpr int few = 5, many = 100;

TEST(FreeMotion, OfABodyPulledAlongAFrictionlessContact) {
  for (int iterations : {few, many}) {
    const Finding finding(twoCubes(frictionless(), push(0.25, -2.0)), iterations);
    EXPECT_EQ(finding.imbalance.body, 1);
    EXPECT_TRUE(finding.isFree) << iterations;
  }
}

TEST(FreeMotion, OfABodyPulledOff) {
  EXPECT_TRUE(Finding(twoCubes(frictionless(), push(0.0, 2.0)), many).isFree);
}

// 2 mu carries what is below 0.25.
TEST(FreeMotion, OfABodyPulledBeyondSliding) {
  EXPECT_TRUE(Finding(twoCubes(friction(0.1), push(0.25, -2.0)), many).isFree);
}

TEST(FreeMotion, IsStoppedByAStickingContact) {
  EXPECT_FALSE(Finding(twoCubes(friction(0.3), push(0.25, -2.0)), few).isFree);
}

TEST(FreeMotion, IsStoppedByWhatIsBonded) {
  EXPECT_FALSE(Finding(twoCubes(laws::makeLaw("Perfect"), push(0.25, -2.0)), few).isFree);
}

TEST(FreeMotion, IsStoppedByAClamp) {
  BoxAssembly cubes = twoCubes(frictionless(), push(0.25, -2.0));
  cubes.hold("stop", "upper_xmin", clamp());
  EXPECT_FALSE(Finding(std::move(cubes), few).isFree);
}

// Springs that let the body go a thousand times its size still hold it, whatever the search direction.
TEST(FreeMotion, IsStoppedBySoftSprings) {
  for (double scale : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    BoxAssembly cubes = twoCubes(frictionless(), push(0.25, -2.0));
    cubes.hold("springs", "upper_xmin", springs(0.25e-3 * 1000.0));
    EXPECT_FALSE(Finding(std::move(cubes), few, scale).isFree) << scale;
  }
}

TEST(FreeMotion, IsStoppedBySoftGlue) {
  for (double scale : {1e-6, 1e-3, 1.0, 1e3}) {
    const Law glue = laws::makeLaw("Linear Elastic", {{"Normal Stiffness", 0.1}, {"Tangential Stiffness", 0.04}});
    EXPECT_FALSE(Finding(twoCubes(glue, push(0.25, -2.0)), few, scale).isFree) << scale;
  }
}

// A contact ahead that is still open by half a cube holds in the end.
TEST(FreeMotion, IsStoppedByAContactFarAhead) {
  BoxAssembly cubes = twoCubes(frictionless(), push(0.25, -2.0));
  cubes.hold("wall", "upper_xmax", laws::makeLaw("Unilateral Contact", {{"Gap", 0.5}}));
  EXPECT_FALSE(Finding(std::move(cubes), few).isFree);
}

// The cube is set down where the wall answers with one to two times the force that is lacking: what remains is not
// larger, and turned round.
TEST(FreeMotion, LandsOnAContactFarAhead) {
  for (double gap : {0.5, 5.0, 50.0}) {
    for (double scale : {0.1, 1.0, 10.0}) {
      BoxAssembly cubes = twoCubes(frictionless(), push(0.25, -2.0));
      cubes.hold("wall", "upper_xmax", laws::makeLaw("Unilateral Contact", {{"Gap", gap}}));
      const Finding finding(std::move(cubes), many, scale);
      ASSERT_TRUE(finding.hasLanded) << gap << " " << scale;
      const double lack = finding.imbalance.force[0], rest = finding.afterLanding.force[0];
      EXPECT_LE(rest / lack, 0.01) << gap << " " << scale;
      EXPECT_GE(rest / lack, -1.05) << gap << " " << scale;
    }
  }
}

TEST(FreeMotion, LandsNowhereWhenFree) {
  EXPECT_FALSE(Finding(twoCubes(frictionless(), push(0.0, 2.0)), many).hasLanded);
}

// The same contact behind the body does not hold it.
TEST(FreeMotion, IsNotStoppedByAContactBehind) {
  BoxAssembly cubes = twoCubes(frictionless(), push(0.25, -2.0));
  cubes.hold("wall", "upper_xmin", frictionless());
  EXPECT_TRUE(Finding(std::move(cubes), many).isFree);
}

/// Lower cube (clamped), middle cube (on a frictionless contact), upper cube (bonded to it, pushed).
BoxAssembly threeCubes() {
  BoxAssembly cubes({{"lower", {0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                     {"middle", {0, 0, 1}, {1, 1, 2}, {2, 2, 2}},
                     {"upper", {0, 0, 2}, {1, 1, 3}, {2, 2, 2}}});
  cubes.hold("bottom", "lower_zmin", clamp());
  cubes.join("contact", "lower_zmax", "middle_zmin", frictionless());
  cubes.join("bond", "middle_zmax", "upper_zmin", laws::makeLaw("Perfect"));
  cubes.hold("top", "upper_zmax", push(0.05, -2.0));
  return cubes;
}

TEST(FreeMotion, OfTwoPiecesThatAreBonded) {
  EXPECT_TRUE(Finding(threeCubes(), many).isFree);
}

TEST(FreeMotion, OfBothIsStoppedByWhatHoldsOne) {
  BoxAssembly cubes = threeCubes();
  cubes.hold("springs", "middle_xmin", springs(10.0));
  EXPECT_FALSE(Finding(std::move(cubes), few).isFree);
}

}  // namespace
}  // namespace harmos::latin
