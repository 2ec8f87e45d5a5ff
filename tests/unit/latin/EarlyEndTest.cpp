#include <gtest/gtest.h>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/latin/March.hpp>

#include "BoxAssembly.hpp"
#include "Chains.hpp"

namespace harmos::latin {
namespace {

/// Pressed twice, then pulled off.
BoxAssembly pulledOff() {
  return twoCubes(laws::makeLaw("Unilateral Contact"),
                  laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}, {{"Z", {-1.0, -2.0, 1.0, -1.0}}}), 4);
}

TEST(EarlyEnd, SaysWhichLoadStepsWereSolved) {
  BoxAssembly cubes = pulledOff();
  base::Timers timers;
  LatinSolver solver(cubes.assembly(), {}, self(), timers);
  const LatinResult result = solver.solve();
  EXPECT_EQ(result.outcome, Outcome::noEquilibrium) << result.reason;
  EXPECT_EQ(result.solvedSteps, 2);
}

TEST(EarlyEnd, KeepsWhatAnEarlierMarchHasFound) {
  BoxAssembly cubes = twoCubes(laws::makeLaw("Unilateral Contact"),
                               laws::makeLaw("Prescribed Traction", {{"Z", 1.0}}, {{"Z", {-1.0, -2.0, -4.0}}}), 3);
  base::Timers timers;
  FixedPoint fixedPoint(cubes.assembly(), {}, self(), timers);
  March march(fixedPoint, 10, 1e-3, 0);
  base::Matrix alpha(fixedPoint.layout().rows(), 3);
  ASSERT_EQ(march.run(alpha, 1e-3, March::Guess::extrapolation), March::End::reached);
  EXPECT_EQ(march.stepsReached(), 3);
  const base::Matrix before(alpha);
  march.setStop([] { return true; });
  ASSERT_EQ(march.run(alpha, 1e-12, March::Guess::state), March::End::stopped);
  EXPECT_LT(march.stepsReached(), 3);
  for (int row = 0; row < alpha.numRows(); ++row) EXPECT_EQ(alpha[2][row], before[2][row]);
}

}  // namespace
}  // namespace harmos::latin
