#include <cmath>

#include <gtest/gtest.h>

#include <harmos/latin/detail/Stagnation.hpp>

namespace harmos::latin {
namespace {

/// Iterations after which a residual that falls by this factor each time is found to stagnate on the way to 1e-3; 0:
/// never.
int foundAfter(double factor, int iterations) {
  Stagnation stagnation;
  double residual = 1.0;
  for (int n = 1; n <= iterations; ++n, residual *= factor) {
    if (stagnation.isFound(residual, 1e-3)) return n;
  }
  return 0;
}

// 150 iterations are ln 1000 = 6.9 at 4.5 % each; what is gained in the first 25 is not asked for any more.
TEST(Stagnation, IsAPaceThatWouldTakeTooLong) {
  EXPECT_EQ(foundAfter(0.9, 60), 0);
  EXPECT_EQ(foundAfter(0.95, 60), 0);
  EXPECT_EQ(foundAfter(0.97, 60), 26);
  EXPECT_EQ(foundAfter(1.0, 60), 26);
  EXPECT_EQ(foundAfter(1.1, 60), 26);
}

TEST(Stagnation, SeesAnIterationThatWasFastComeToAHalt) {
  Stagnation stagnation;
  double residual = 1.0;
  for (int n = 0; n < 40; ++n, residual *= 0.9) EXPECT_FALSE(stagnation.isFound(residual, 1e-3)) << n;
  int more = 0;
  while (more < 100 && !stagnation.isFound(residual, 1e-3)) ++more;
  EXPECT_GT(more, 5);
  EXPECT_LE(more, 25);
}

// Jumps up do not count, as long as the best falls.
TEST(Stagnation, LooksAtTheBest) {
  Stagnation stagnation;
  for (int n = 0; n < 60; ++n) {
    const double residual = std::pow(0.9, n) * (n % 2 == 0 ? 1.0 : 5.0);
    EXPECT_FALSE(stagnation.isFound(residual, 1e-3)) << n;
  }
}

}  // namespace
}  // namespace harmos::latin
