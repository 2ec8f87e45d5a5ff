#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include <harmos/base/Timers.hpp>

namespace harmos::base {
namespace {

TEST(Timers, InnerPhaseStopsTheOuter) {
  using namespace std::chrono_literals;
  Timers timers;
  for (int i = 0; i < 2; ++i) {
    const auto outer = timers.start("outer");
    std::this_thread::sleep_for(2ms);
    const auto inner = timers.start("inner");
    std::this_thread::sleep_for(20ms);
  }
  ASSERT_EQ(timers.phases().size(), 2u);
  EXPECT_EQ(timers.phases()[0].name, "outer");
  EXPECT_EQ(timers.phases()[0].starts, 2);
  EXPECT_GE(timers.phases()[0].wallSeconds, 0.004);
  EXPECT_GE(timers.phases()[1].wallSeconds, 0.040);
  // Sleeping costs no CPU time; half the wall time leaves room for a busy machine.
  EXPECT_LT(timers.phases()[1].cpuSeconds, 0.5 * timers.phases()[1].wallSeconds);
}

TEST(Timers, PeakMemoryIsInBytes) {
  EXPECT_GT(peakMemory(), std::size_t{1} << 20);
}

}  // namespace
}  // namespace harmos::base
