#include <harmos/base/MachineSpeed.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace harmos::base {
namespace {

TEST(MachineSpeed, IsAboutTheSameTheNextMoment) {
  const double first = machineSlowness(), second = machineSlowness();
  EXPECT_TRUE(std::isfinite(first));
  EXPECT_GT(first, 0.0);
  EXPECT_LT(std::abs(std::log(second / first)), std::log(5.0));  // other work may begin between them
}

}  // namespace
}  // namespace harmos::base
