// A programme whose solution and multipliers are known by hand.
#include <gtest/gtest.h>

#include <limits>

#include <harmos/statics/LinearProgramme.hpp>

namespace harmos::statics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Least -x with x <= 5 and x - y = 0: y stops it as soon as y is bounded.
TEST(LinearProgramme, GrowsByColumns) {
  LinearProgramme programme({0.0});
  programme.add({{0, 1.0}}, 0.0, 5.0, -1.0);
  programme.add({{0, -1.0}}, 0.0, 2.0, 0.0);
  ASSERT_TRUE(programme.solve());
  EXPECT_NEAR(programme.solution()[0], 2.0, 1e-12);
  EXPECT_NEAR(programme.multipliers()[0], -1.0, 1e-12);
  programme.add({{0, -1.0}}, 0.0, infinity, 0.0);
  ASSERT_TRUE(programme.solve());
  EXPECT_EQ(programme.columns(), 3);
  EXPECT_NEAR(programme.solution()[0], 5.0, 1e-12);
  EXPECT_NEAR(programme.multipliers()[0], 0.0, 1e-12);
}

TEST(LinearProgramme, MeetsItsRightSide) {
  LinearProgramme programme({0.5, -1.0});
  programme.add({{0, 2.0}}, 0.0, infinity, 3.0);
  programme.add({{1, -4.0}}, 0.0, infinity, 1.0);
  ASSERT_TRUE(programme.solve());
  EXPECT_NEAR(programme.solution()[0], 0.25, 1e-12);
  EXPECT_NEAR(programme.solution()[1], 0.25, 1e-12);
  EXPECT_NEAR(programme.value(), 1.0, 1e-12);
}

TEST(LinearProgramme, SaysThatNothingMeetsItsRightSide) {
  LinearProgramme programme({-1.0});
  programme.add({{0, 1.0}}, 0.0, infinity, 0.0);
  EXPECT_FALSE(programme.solve());
}

TEST(LinearProgramme, WithoutALeastValueHasNoSolution) {
  LinearProgramme programme({0.0});
  programme.add({}, 0.0, infinity, -1.0);
  EXPECT_FALSE(programme.solve());
}

}  // namespace
}  // namespace harmos::statics
