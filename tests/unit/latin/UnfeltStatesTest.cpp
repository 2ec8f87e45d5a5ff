#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

BoxAssembly gluedCubes(bool isConsistent) {
  return twoCubes(laws::makeLaw("Perfect"), laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}), 2, isConsistent);
}

TEST(UnfeltStates, LeaveTheImageAsItIs) {
  for (const bool isConsistent : {false, true}) {
    BoxAssembly cubes = gluedCubes(isConsistent);
    base::Timers timers;
    FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
    const UnfeltStates& unfelt = fixedPoint.linearStage().unfelt();
    ASSERT_FALSE(unfelt.isEmpty());
    base::Matrix alpha(fixedPoint.layout().rows(), 2), image(alpha), felt(alpha), imageOfFelt(alpha), again(alpha);
    randomize(alpha);
    felt.assign(alpha);
    unfelt.remove(felt);
    EXPECT_GT(fixedPoint.metric().distance(alpha, felt), 0.1 * fixedPoint.metric().norm(alpha));
    again.assign(felt);
    unfelt.remove(again);
    EXPECT_LT(fixedPoint.metric().distance(again, felt), 1e-13 * fixedPoint.metric().norm(alpha));
    fixedPoint.apply(alpha, image);
    fixedPoint.apply(felt, imageOfFelt);
    EXPECT_LT(fixedPoint.metric().distance(image, imageOfFelt), 1e-11 * fixedPoint.metric().norm(image));
  }
}

// The whole difference of two states may grow, by the motion of a stiff part on a soft one.
TEST(UnfeltStates, AreAllThatAPerfectInterfaceExpands) {
  BoxAssembly cubes = gluedCubes(false);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  const UnfeltStates& unfelt = fixedPoint.linearStage().unfelt();
  for (unsigned seed = 1; seed < 20; ++seed) {
    base::Matrix a(fixedPoint.layout().rows(), 2), b(a), imageOfA(a), imageOfB(a);
    randomize(a, seed);
    randomize(b, seed + 100);
    fixedPoint.apply(a, imageOfA);
    fixedPoint.apply(b, imageOfB);
    a -= b;
    imageOfA -= imageOfB;
    unfelt.remove(a);
    unfelt.remove(imageOfA);
    EXPECT_LT(fixedPoint.metric().norm(imageOfA), fixedPoint.metric().norm(a)) << seed;
  }
}

TEST(UnfeltStates, AreNotLookedForAtOtherLaws) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Unilateral Contact"), laws::makeLaw("Symmetry"));
  base::Timers timers;
  const FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  EXPECT_TRUE(fixedPoint.linearStage().unfelt().isEmpty());
}

}  // namespace
}  // namespace harmos::latin
