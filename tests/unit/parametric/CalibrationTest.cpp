#include <cmath>

#include <gtest/gtest.h>

#include <harmos/parametric/Calibration.hpp>
#include <harmos/parametric/Trust.hpp>

namespace harmos::parametric {
namespace {

Calibration::Observation observation(double force, double forceError, double response, double responseError) {
  return {{force, response}, forceError, responseError};
}

TEST(Calibration, TakesTheSmallestRatios) {
  Calibration calibration(1e-2);
  EXPECT_TRUE(std::isinf(calibration.estimate({1e-9, 1e-9})));
  EXPECT_FALSE(calibration.accepts({1e-9, 1e-9}));
  EXPECT_TRUE(calibration.add(
      calibration.ratiosOf({observation(4e-3, 2e-2, 3e-2, 3e-2), observation(1e-3, 1e-2, 1e-2, 2e-2)})));
  EXPECT_DOUBLE_EQ(calibration.ratios().force, 0.1);
  EXPECT_DOUBLE_EQ(calibration.ratios().response, 0.5);
  EXPECT_DOUBLE_EQ(calibration.estimate({3e-4, 1e-3}), 3e-3);
  EXPECT_DOUBLE_EQ(calibration.estimate({1e-4, 2e-3}), 4e-3);
  EXPECT_FALSE(calibration.add(calibration.ratiosOf({observation(4e-3, 2e-2, 3e-2, 3e-2)})));
  const results::Indicators target = calibration.target();  // half the accuracy before the fifth run
  EXPECT_DOUBLE_EQ(target.force, 0.5e-3);
  EXPECT_DOUBLE_EQ(target.response, 2.5e-3);
  EXPECT_TRUE(calibration.accepts({0.99 * target.force, 0.99 * target.response}));
  EXPECT_FALSE(calibration.accepts({1.01 * target.force, 0.0}));
  EXPECT_FALSE(calibration.accepts({0.0, 1.01 * target.response}));
}

TEST(Calibration, HasRatiosOfAtMostOneAndLooksOnlyNearTheAccuracy) {
  Calibration calibration(1e-2);
  calibration.add(calibration.ratiosOf({observation(1.0, 1e-2, 1.0, 1e-2), observation(1e-9, 1e-4, 1e-9, 0.5)}));
  EXPECT_DOUBLE_EQ(calibration.ratios().force, 1.0);
  EXPECT_DOUBLE_EQ(calibration.ratios().response, 1.0);
}

TEST(Calibration, IsMoreCarefulAtFirst) {
  Calibration calibration(1e-2);
  for (int run = 1; run <= 5; ++run) {
    calibration.add({});
    EXPECT_EQ(calibration.accepts({6e-3, 0.0}), run == 5);
  }
  EXPECT_FALSE(calibration.accepts({7e-3, 0.0}));
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
