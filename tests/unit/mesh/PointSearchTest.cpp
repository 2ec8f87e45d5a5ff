#include <gtest/gtest.h>

#include <random>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/PointSearch.hpp>

namespace harmos::mesh {
namespace {

std::vector<base::Vector3> randomPoints(int count) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(0, 9);  // few values, so that many points and distances coincide
  std::vector<base::Vector3> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({0.1 * coordinate(random), 0.1 * coordinate(random), 0.1 * coordinate(random)});
  }
  return points;
}

TEST(PointSearch, AgreesWithExhaustiveSearch) {
  const auto points = randomPoints(500);
  const PointSearch search(points);
  for (const base::Vector3& from : randomPoints(600)) {
    int best = 0;
    std::vector<int> near;
    for (int i = 0; i < 500; ++i) {
      const double away = distance(from, points[i]);
      if (away < distance(from, points[best])) best = i;
      if (away <= 0.25) near.push_back(i);
    }
    EXPECT_EQ(search.nearest(from).index, best);
    EXPECT_EQ(search.within(from, 0.25), near);
  }
}

TEST(PointSearch, FindsNothingAmongNoPoints) {
  const PointSearch search({});
  EXPECT_EQ(search.nearest({0.0, 0.0, 0.0}).index, -1);
  EXPECT_TRUE(search.within({0.0, 0.0, 0.0}, 1.0).empty());
}

}  // namespace
}  // namespace harmos::mesh
