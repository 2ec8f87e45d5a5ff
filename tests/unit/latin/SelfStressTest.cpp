// Tractions that nodes do not tell apart: sets of laws, the least share, and how far it can go.
#include <gtest/gtest.h>

#include <cmath>

#include <harmos/latin/detail/SelfStress.hpp>

namespace harmos::latin {
namespace {

using base::Vector3;

const base::Frame axes{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};

/// Two pairs of these areas between the same two nodes.
RedundantGroup twoPairs(double area1, double area2) {
  RedundantGroup group;
  group.pairs = {{0, 0, area1, {}}, {1, 0, area2, {}}};
  group.equilibrium.shape(6, 6);
  for (int i = 0; i < 2; ++i) {
    for (int c = 0; c < 3; ++c) {
      group.equilibrium(c, 3 * i + c) = std::sqrt(group.pairs[i].area);
      group.equilibrium(3 + c, 3 * i + c) = -std::sqrt(group.pairs[i].area);
    }
  }
  return group;
}

void expectNear(const Vector3& a, const Vector3& b, double tolerance = 1e-9) {
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << c;
}

TEST(TractionSet, FindsTheNearestOfACone) {
  const TractionSet cone = TractionSet::cone(axes, 0.5, 3);
  expectNear(cone.nearest({-2, 0.6, 0.8}), {-2, 0.6, 0.8});  // on it
  expectNear(cone.nearest({3, 0, 0}), {});                   // in the polar cone
  const Vector3 x{-1, 3, 4}, y = cone.nearest(x);
  EXPECT_NEAR(base::tangentialNorm(y), -0.5 * y[0], 1e-12);
  EXPECT_NEAR(base::dot(x - y, y), 0.0, 1e-12);  // what is left is at right angles
  EXPECT_NEAR(y[1] / y[2], 0.75, 1e-12);
  const TractionSet ray = TractionSet::ray({-1, 0.5, 0});
  expectNear(ray.nearest({2, -1, 0}), {});
  expectNear(ray.nearest({-1, 0.5, 7}), {-1, 0.5, 0});
}

TEST(SelfStress, IsNoneOfOnePair) {
  RedundantGroup group = twoPairs(1, 1);
  group.pairs.pop_back();
  group.equilibrium.reshape(6, 3);
  EXPECT_FALSE(SelfStress(group, {TractionSet::cone(axes, 1.0, 3)}, {Vector3{-1, 0, 0}}).exists());
}

TEST(SelfStress, OfJointsSharesByArea) {
  const RedundantGroup group = twoPairs(1, 3);
  const std::vector<Vector3> found{{4, -4, 0}, {0, 0, 8}};
  const std::vector<Vector3> all(axes.begin(), axes.end());
  const SelfStress stress(group, {TractionSet::span(found[0], all), TractionSet::span(found[1], all)}, found);
  ASSERT_TRUE(stress.exists());
  // The same traction in both: sum of h t over the sum of h.
  for (const Vector3& t : stress.least()) expectNear(t, {1, -1, 6});
  EXPECT_FALSE(stress.farthest({Vector3{1, 0, 0}, Vector3{}}));
}

// A floor and a wall at one node, friction 1: forces (-p2 + s1, -p1 + s2) with |s| <= p.
TEST(SelfStress, OfACornerStaysWithinTheCones) {
  const RedundantGroup group = twoPairs(1, 1);
  const base::Frame floor{Vector3{0, 1, 0}, Vector3{-1, 0, 0}, Vector3{0, 0, 1}};
  const std::vector<TractionSet> sets{TractionSet::cone(axes, 0.2, 2), TractionSet::cone(floor, 0.2, 2)};
  const std::vector<Vector3> found{{-1, -0.2, 0}, {0, -9.8, 0}};
  const SelfStress stress(group, sets, found);
  ASSERT_TRUE(stress.exists());
  const std::vector<Vector3> least = stress.least();
  expectNear(least[0] + least[1], {-1, -10, 0});
  for (std::size_t i = 0; i < 2; ++i) expectNear(sets[i].nearest(least[i]), least[i]);
  // Against a scan of all: t1 = (-p, s), t2 = (p - 1, -10 - s).
  double best = 1e9;
  Vector3 at{};
  double lowest = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    for (int j = -800; j <= 800; ++j) {
      const double p = 1e-3 * i, s = 1e-3 * j;
      if (std::abs(s) > 0.2 * p || std::abs(p - 1.0) > 0.2 * (10.0 + s)) continue;
      const double sum = p * p + s * s + (p - 1) * (p - 1) + (10 + s) * (10 + s);
      lowest = std::max(lowest, p);
      if (sum < best) {
        best = sum;
        at = {-p, s, 0};
      }
    }
  }
  expectNear(least[0], at, 5e-3);
  const auto farthest = stress.farthest({Vector3{-1, 0, 0}, Vector3{}});
  ASSERT_TRUE(farthest);
  EXPECT_NEAR(-(*farthest)[0][0], lowest, 2e-2);
  expectNear((*farthest)[0] + (*farthest)[1], {-1, -10, 0});
}

}  // namespace
}  // namespace harmos::latin
