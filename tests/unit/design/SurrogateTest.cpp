#include <gtest/gtest.h>

#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/design/LatinHypercubeDesign.hpp>
#include <harmos/design/RandomDesign.hpp>
#include <harmos/design/Surrogate.hpp>

namespace harmos::design {
namespace {

using Points = std::vector<std::vector<double>>;

std::vector<Axis> box() {
  std::vector<Axis> axes(3);
  axes[0].lower = 0.1;
  axes[0].upper = 0.5;
  axes[1].upper = axes[2].upper = 300.0;
  return axes;
}

/// As a slip force depends on friction and two preloads, with a kink.
double force(const std::vector<double>& x) {
  return x[0] * (x[1] + x[2]) + std::abs(x[1] - x[2]) * x[0] * x[0];
}

double smooth(const std::vector<double>& x) {
  return 3.0 + x[0] * (x[1] - 0.1 * x[2]) + 1e-4 * x[1] * x[1];
}

std::vector<double> valuesOf(const Points& points, double (*function)(const std::vector<double>&)) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(function(point));
  return values;
}

TEST(Surrogate, QuadraticFunctionsAreExact) {
  const Points points = LatinHypercubeDesign(30, 1).points(box());
  const Surrogate surrogate(points, valuesOf(points, smooth), 0.0);
  EXPECT_EQ(surrogate.model().degree, 2);
  for (const auto& point : RandomDesign(20, 2).points(box())) {
    const auto prediction = surrogate.evaluate(point);
    EXPECT_NEAR(prediction.value, smooth(point), 1e-6 * 200.0);
    EXPECT_LT(prediction.deviation, 1e-4 * 200.0);
  }
}

TEST(Surrogate, ErrorBarsHoldOnPointsThatItHasNotSeen) {
  for (const int count : {30, 80}) {
    const Points points = LatinHypercubeDesign(count, 3).points(box());
    const Surrogate surrogate(points, valuesOf(points, force), 0.0);
    int outside = 0;
    double largest = 0.0;
    const Points others = RandomDesign(500, 4).points(box());
    for (const auto& point : others) {
      const auto prediction = surrogate.evaluate(point);
      const double error = std::abs(prediction.value - force(point));
      if (error > 1.96 * prediction.deviation) ++outside;
      largest = std::max(largest, error);
    }
    // At a kink errors are not normal; 10 % outside of bars of 95 % is what there is.
    EXPECT_LT(outside, 50) << count;
    EXPECT_LT(largest, count == 30 ? 60.0 : 40.0) << count;  // of 370
  }
}

TEST(Surrogate, PassesThroughItsPointsAndKnowsItsBox) {
  const Points points = LatinHypercubeDesign(40, 5).points(box());
  const Surrogate surrogate(points, valuesOf(points, force), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto prediction = surrogate.evaluate(points[i]);
    EXPECT_NEAR(prediction.value, force(points[i]), 1.0);
    EXPECT_TRUE(prediction.isInside);
  }
  EXPECT_FALSE(surrogate.evaluate({0.6, 100.0, 100.0}).isInside);
  EXPECT_GT(surrogate.evaluate({0.9, 100.0, 100.0}).deviation, surrogate.evaluate({0.3, 100.0, 100.0}).deviation);
}

TEST(Surrogate, MorePointsLeaveLessDoubt) {
  const Points points = LatinHypercubeDesign(30, 6).points(box());
  const Surrogate surrogate(points, valuesOf(points, force), 0.0);
  const Points candidates = {{0.3, 150.0, 150.0}, {0.45, 20.0, 280.0}};
  const auto before = surrogate.deviationsWith({}, candidates);
  const auto after = surrogate.deviationsWith({candidates[1]}, candidates);
  EXPECT_NEAR(before[0], surrogate.evaluate(candidates[0]).deviation, 1e-9);
  EXPECT_LE(after[0], before[0]);
  EXPECT_LT(after[1], 0.2 * before[1]);
}

TEST(Surrogate, SmallAndConstantData) {
  EXPECT_THROW(Surrogate({{1.0}, {2.0}}, {1.0, 2.0}, 0.0), base::Error);
  EXPECT_THROW(Surrogate({{1.0}, {2.0}, {3.0}}, {1.0, 2.0, NAN}, 0.0), base::Error);
  const Surrogate constant({{1.0}, {2.0}, {4.0}}, {7.0, 7.0, 7.0}, 0.0);
  EXPECT_NEAR(constant.evaluate({3.0}).value, 7.0, 1e-9);
  EXPECT_NEAR(constant.evaluate({3.0}).deviation, 0.0, 1e-6);
  const Surrogate line({{1.0}, {2.0}, {3.0}, {4.0}}, {1.0, 2.0, 3.0, 4.0}, 0.0);
  EXPECT_NEAR(line.evaluate({2.5}).value, 2.5, 1e-6);
}

}  // namespace
}  // namespace harmos::design
