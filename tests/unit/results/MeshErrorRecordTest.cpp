#include <gtest/gtest.h>

#include <harmos/results/MeshErrorRecord.hpp>

namespace harmos::results {
namespace {

TEST(MeshErrorRecord, IsToldWithOneDigit) {
  EXPECT_EQ(meshErrorInWords(0.0049), "below 0.5 %");
  EXPECT_EQ(meshErrorInWords(0.0051), "about 0.5 %");
  EXPECT_EQ(meshErrorInWords(0.0873), "about 9 %");
  EXPECT_EQ(meshErrorInWords(0.0, 0.004), "below 0.5 %");
  EXPECT_EQ(meshErrorInWords(0.0, 0.13), "up to 10 %");
  EXPECT_EQ(meshErrorInWords(0.11, 0.14), "about 10 %");
  EXPECT_EQ(meshErrorInWords(0.032, 0.19), "about 3 to 20 %");
}

}  // namespace
}  // namespace harmos::results
