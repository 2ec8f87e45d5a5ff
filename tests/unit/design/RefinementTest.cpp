#include <gtest/gtest.h>

#include <cmath>

#include <harmos/design/RandomDesign.hpp>
#include <harmos/design/Refinement.hpp>
#include <harmos/design/SurrogateFit.hpp>

namespace harmos::design {
namespace {

std::vector<Axis> box() {
  std::vector<Axis> axes(3);
  axes[0].lower = 0.1;
  axes[0].upper = 0.5;
  axes[1].lower = axes[2].lower = 0.025;
  axes[1].upper = axes[2].upper = 0.3;
  return axes;
}

double force(const std::vector<double>& x) {
  return 2.0 * x[0] * 3.3e4 * (x[1] + x[2]) * (1.0 - 0.1 * x[0]) + 400.0 * std::sin(6.0 * x[0]) * x[1];
}

struct Outcome {
  Refinement::Points points;
  std::vector<double> values;
  bool isReached = false;
};

Outcome refine(const Refinement::Options& options, const std::vector<Axis>& axes,
               double (*function)(const std::vector<double>&)) {
  Refinement refinement(axes, options);
  Outcome outcome;
  for (auto next = refinement.begin(); !next.empty(); next = refinement.next(outcome.points, outcome.values, 1e-6)) {
    for (auto& point : next) {
      outcome.values.push_back(function(point));
      outcome.points.push_back(std::move(point));
    }
  }
  outcome.isReached = refinement.isReached();
  return outcome;
}

TEST(Refinement, ReachesTheToleranceEverywhere) {
  for (const double tolerance : {1e-2, 1e-3}) {
    Refinement::Options options;
    options.tolerance = tolerance;
    const Outcome outcome = refine(options, box(), force);
    EXPECT_TRUE(outcome.isReached);
    EXPECT_LT(outcome.points.size(), 100u);
    const auto surrogate = fitSurrogate(outcome.points, outcome.values, 1e-6);
    double largest = 0.0, error = 0.0;
    for (const auto& point : RandomDesign(1000, 3).points(box())) {
      error = std::max(error, std::abs(surrogate->evaluate(point).value - force(point)));
      largest = std::max(largest, std::abs(force(point)));
    }
    EXPECT_LT(error, tolerance * largest);
  }
}

TEST(Refinement, EndsAtTheLargestNumber) {
  Refinement::Options options;
  options.tolerance = 1e-9;
  options.maximumCount = 37;
  const Outcome outcome =
      refine(options, box(), [](const std::vector<double>& x) { return std::sin(40.0 * x[0] * x[1]); });
  EXPECT_FALSE(outcome.isReached);
  EXPECT_EQ(outcome.points.size(), 37u);
}

TEST(Refinement, KeepsToWhatIsAllowed) {
  const auto isAllowed = [](const std::vector<double>& point) { return point[1] >= point[2]; };
  Refinement refinement(box(), {}, isAllowed);
  Refinement::Points points;
  std::vector<double> values;
  for (auto next = refinement.begin(); !next.empty(); next = refinement.next(points, values, 1e-6)) {
    for (const auto& point : next) {
      EXPECT_TRUE(isAllowed(point));
      values.push_back(force(point));
      points.push_back(point);
    }
  }
  EXPECT_TRUE(refinement.isReached());
  // Asked again, as an interrupted study does: nothing more to do.
  EXPECT_TRUE(Refinement(box(), {}, isAllowed).next(points, values, 1e-6).empty());
}

TEST(Refinement, TakesLevelsAndExhaustsThem) {
  std::vector<Axis> axes(1);
  axes[0].levels = {3, 1, 2, 4, 5, 7};
  Refinement::Options options;
  options.tolerance = 1e-9;
  const Outcome outcome = refine(options, axes, [](const std::vector<double>& x) { return x[0] == 4.0 ? 9.0 : x[0]; });
  EXPECT_TRUE(outcome.isReached);
  EXPECT_EQ(outcome.points.size(), 6u);
}

}  // namespace
}  // namespace harmos::design
