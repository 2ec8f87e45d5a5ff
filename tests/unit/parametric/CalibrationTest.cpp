#include <cmath>

#include <gtest/gtest.h>

#include <harmos/parametric/Calibration.hpp>
#include <harmos/parametric/Trust.hpp>

namespace harmos::parametric {
namespace {

/// Of a study with one response.
Calibration::Observation observation(double force, double forceError, double response, double responseError) {
  return {{force, 0.0, {response}}, forceError, {responseError}};
}

results::Indicators indicators(double force, double response) {
  return {force, 0.0, {response}};
}

TEST(Calibration, TakesTheSmallestRatios) {
  Calibration calibration(1e-2, 1);
  EXPECT_TRUE(std::isinf(calibration.estimate(indicators(1e-9, 1e-9))));
  EXPECT_FALSE(calibration.accepts(indicators(1e-9, 1e-9)));
  EXPECT_TRUE(calibration.add(
      calibration.ratiosOf({observation(4e-3, 2e-2, 3e-2, 3e-2), observation(1e-3, 1e-2, 1e-2, 2e-2)})));
  EXPECT_DOUBLE_EQ(calibration.ratios().force, 0.1);
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[0], 0.5);
  EXPECT_DOUBLE_EQ(calibration.estimate(indicators(3e-4, 1e-3)), 3e-3);
  EXPECT_DOUBLE_EQ(calibration.estimate(indicators(1e-4, 2e-3)), 4e-3);
  EXPECT_DOUBLE_EQ(calibration.estimateOf(0, indicators(3e-4, 1e-3)), 2e-3);
  EXPECT_FALSE(calibration.add(calibration.ratiosOf({observation(4e-3, 2e-2, 3e-2, 3e-2)})));
  const results::Indicators target = calibration.target();  // half the accuracy before the fifth run
  EXPECT_DOUBLE_EQ(target.force, 0.5e-3);
  EXPECT_DOUBLE_EQ(target.balance, 5e-3);
  EXPECT_DOUBLE_EQ(target.responses[0], 2.5e-3);
  EXPECT_TRUE(calibration.accepts(indicators(0.99 * target.force, 0.99 * target.responses[0])));
  EXPECT_FALSE(calibration.accepts(indicators(1.01 * target.force, 0.0)));
  EXPECT_FALSE(calibration.accepts(indicators(0.0, 1.01 * target.responses[0])));
  EXPECT_FALSE(calibration.accepts({0.0, 1.01 * target.balance, {0.0}}));
}

TEST(Calibration, HasRatiosOfAtMostOneAndLooksOnlyNearTheAccuracy) {
  Calibration calibration(1e-2, 1);
  calibration.add(calibration.ratiosOf({observation(1.0, 1e-2, 1.0, 1e-2), observation(1e-9, 1e-4, 1e-9, 0.5)}));
  EXPECT_DOUBLE_EQ(calibration.ratios().force, 1.0);
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[0], 1.0);
}

TEST(Calibration, KnowsEachResponse) {
  Calibration calibration(1e-2, 2);
  calibration.add({});
  EXPECT_DOUBLE_EQ(calibration.estimate({0.0, 1e-4, {2e-4, 3e-4}}), 3e-4);
  EXPECT_TRUE(calibration.add(calibration.ratiosOf({{{0.0, 1e-3, {2e-3, 1e-3}}, 0.0, {4e-3, 1e-2}}})));
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[0], 0.5);
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[1], 0.1);
  EXPECT_DOUBLE_EQ(calibration.estimateOf(0, {0.0, 1e-3, {2e-3, 3e-3}}), 4e-3);
  EXPECT_DOUBLE_EQ(calibration.estimateOf(1, {0.0, 1e-3, {2e-3, 3e-3}}), 3e-2);
  EXPECT_DOUBLE_EQ(calibration.target().responses[1], 5e-4);
}

TEST(Calibration, AsksForBalanceWithoutResponses) {
  Calibration calibration(1e-2, 0);
  calibration.add({});
  EXPECT_DOUBLE_EQ(calibration.estimate({1e-4, 3e-3, {}}), 3e-3);
}

// A response that is right long before the others is known not to be worse; what is zero teaches nothing.
TEST(Calibration, LearnsFromResponsesThatAreRightBeforeOthers) {
  Calibration calibration(1e-2, 2);
  EXPECT_TRUE(calibration.add(calibration.ratiosOf({{{0.0, 1e-3, {1e-2, 1e-4}}, 0.0, {1e-2, 1e-9}}})));
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[0], 1.0);
  EXPECT_DOUBLE_EQ(calibration.ratios().responses[1], 0.1);
  EXPECT_FALSE(calibration.add(calibration.ratiosOf({{{0.0, 1e-3, {1e-2, 0.0}}, 0.0, {1e-2, 1e-9}}})));
  EXPECT_FALSE(calibration.add(calibration.ratiosOf({{{0.0, 1e-3, {1e-9, 1e-9}}, 0.0, {1e-4, 1e-4}}})));
}

TEST(Calibration, IsMoreCarefulAtFirst) {
  Calibration calibration(1e-2, 1);
  for (int run = 1; run <= 5; ++run) {
    calibration.add({});
    EXPECT_EQ(calibration.accepts(indicators(6e-3, 0.0)), run == 5);
  }
  EXPECT_FALSE(calibration.accepts(indicators(7e-3, 0.0)));
}

// P(0 of n) = (1 - p)^n = 0.05, and the tabulated value for 1 of 20.
TEST(Trust, BoundsFalseClaims) {
  EXPECT_NEAR(falseClaimBound(13, 0), 1.0 - std::pow(0.05, 1.0 / 13.0), 1e-12);
  EXPECT_NEAR(falseClaimBound(20, 1), 0.2161, 1e-4);
  EXPECT_EQ(falseClaimBound(0, 0), 1.0);
  EXPECT_EQ(falseClaimBound(2, 2), 1.0);
}

}  // namespace
}  // namespace harmos::parametric
