#include <atomic>

#include <gtest/gtest.h>

#include <harmos/base/OneThread.hpp>

// What GNU's compiler makes of a parallel region; present when its OpenMP runtime is loaded.
extern "C" __attribute__((weak)) void GOMP_parallel(void (*work)(void*), void* data, unsigned threads, unsigned flags);

namespace harmos::base {
namespace {

TEST(OneThread, DoesTheWorkOfRegionsThatAskForMore) {
  if (!GOMP_parallel) GTEST_SKIP() << "no OpenMP runtime of GNU";
  useOneThread();
  std::atomic<int> threads{0};
  GOMP_parallel([](void* counter) { ++*static_cast<std::atomic<int>*>(counter); }, &threads, 4, 0);
  EXPECT_EQ(threads, 1);
}

}  // namespace
}  // namespace harmos::base
