#include <gtest/gtest.h>

#include <harmos/results/ScalarResponse.hpp>

namespace harmos::results {
namespace {

double valueOf(ScalarResponse::Kind kind, double time = 0.0) {
  ScalarResponse response;
  response.kind = kind;
  response.time = time;
  return response.evaluate({1.0, 2.0, 4.0}, {-3.0, 2.0, 1.0});
}

TEST(ScalarResponse, ReducesACurveToANumber) {
  EXPECT_EQ(valueOf(ScalarResponse::Kind::maximum), 2.0);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::minimum), -3.0);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::final), 1.0);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::largestMagnitude), -3.0);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::atTime, 3.0), 1.5);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::atTime, 2.0), 2.0);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::atTime, 0.5), -1.5);
  EXPECT_EQ(valueOf(ScalarResponse::Kind::atTime, 9.0), 1.0);
}

}  // namespace
}  // namespace harmos::results
