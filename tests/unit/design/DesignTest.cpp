#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/design/GridDesign.hpp>
#include <harmos/design/LatinHypercubeDesign.hpp>
#include <harmos/design/ListDesign.hpp>
#include <harmos/design/RandomDesign.hpp>
#include <harmos/design/SobolDesign.hpp>

namespace harmos::design {
namespace {

using Points = std::vector<std::vector<double>>;

Axis between(double lower, double upper) {
  Axis axis;
  axis.name = "x";
  axis.lower = lower;
  axis.upper = upper;
  return axis;
}

Axis levels(std::vector<double> values) {
  Axis axis;
  axis.name = "n";
  axis.levels = std::move(values);
  return axis;
}

TEST(Axis, LevelsAreWhatAUserWouldWrite) {
  EXPECT_EQ(evenLevels(0.1, 0.5, 9), (std::vector<double>{0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5}));
  EXPECT_EQ(evenLevels(0.025, 0.3, 12)[5], 0.15);
  EXPECT_EQ(evenLevels(3.0, 7.0, 1), (std::vector<double>{3.0}));
  EXPECT_EQ(evenLevels(1.0, 0.0, 3), (std::vector<double>{1.0, 0.5, 0.0}));
}

TEST(GridDesign, LastAxisRunsFastest) {
  EXPECT_EQ(GridDesign().points({levels({1, 2}), levels({10, 20, 30})}),
            (Points{{1, 10}, {1, 20}, {1, 30}, {2, 10}, {2, 20}, {2, 30}}));
  EXPECT_THROW(GridDesign().points({between(0, 1)}), base::Error);
  const std::vector<Axis> many(10, levels(std::vector<double>(10, 1.0)));
  EXPECT_THROW(GridDesign().points(many), base::Error);
}

TEST(ListDesign, WantsAValuePerAxis) {
  EXPECT_EQ(ListDesign({{1, 2}}).points({between(0, 1), between(0, 1)}), (Points{{1, 2}}));
  EXPECT_THROW(ListDesign({{1, 2}}).points({between(0, 1)}), base::Error);
}

TEST(Designs, AreReproducibleAndStayInTheBox) {
  const std::vector<Axis> axes = {between(-2, 3), levels({1, 4, 9}), between(5, 6)};
  const auto check = [&](const Design& design, const Design& same, const Design& other) {
    const Points points = design.points(axes);
    ASSERT_EQ(points.size(), 50u);
    EXPECT_EQ(points, same.points(axes));
    EXPECT_NE(points, other.points(axes));
    for (const auto& point : points) {
      EXPECT_TRUE(-2 <= point[0] && point[0] < 3);
      EXPECT_TRUE(point[1] == 1 || point[1] == 4 || point[1] == 9);
      EXPECT_TRUE(5 <= point[2] && point[2] < 6);
    }
  };
  check(RandomDesign(50, 7), RandomDesign(50, 7), RandomDesign(50, 8));
  check(LatinHypercubeDesign(50, 7), LatinHypercubeDesign(50, 7), LatinHypercubeDesign(50, 8));
  check(SobolDesign(50, 7), SobolDesign(50, 7), SobolDesign(50, 8));
  check(SobolDesign(50, 0), SobolDesign(50, 0), SobolDesign(50, 1));
}

// The sequence must not depend on the compiler: these numbers are what any implementation of the Mersenne twister
// gives.
TEST(RandomDesign, GivesTheSameEverywhere) {
  const Points points = RandomDesign(1, 5489).points({between(0, 1)});
  EXPECT_NEAR(points[0][0], 14514284786278117030ull * std::pow(2.0, -64), 1e-15);
}

TEST(LatinHypercubeDesign, HitsEveryStratumOnce) {
  const Points points = LatinHypercubeDesign(20, 1).points({between(0, 20), between(0, 20)});
  for (const std::size_t a : {0u, 1u}) {
    std::set<int> strata;
    for (const auto& point : points) strata.insert(static_cast<int>(point[a]));
    EXPECT_EQ(strata.size(), 20u);
  }
}

TEST(SobolDesign, BeginsAsInTheLiterature) {
  const Points points = SobolDesign(4, 0).points({between(0, 1), between(0, 1), between(0, 1)});
  EXPECT_EQ(points, (Points{{0.5, 0.5, 0.5}, {0.75, 0.25, 0.25}, {0.25, 0.75, 0.75}, {0.375, 0.375, 0.625}}));
}

// 2^m - 1 points after the corner, together with it, hit every one of 2^m equal boxes of some shapes once.
TEST(SobolDesign, IsEvenInTwentyDimensions) {
  const Points points = SobolDesign(63, 0).points(std::vector<Axis>(20, between(0, 64)));
  for (std::size_t a = 0; a < 20; ++a) {
    std::set<int> strata = {0};
    for (const auto& point : points) strata.insert(static_cast<int>(point[a]));
    EXPECT_EQ(strata.size(), 64u) << a;
  }
}

}  // namespace
}  // namespace harmos::design
