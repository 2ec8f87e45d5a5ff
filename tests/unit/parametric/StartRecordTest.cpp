#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <harmos/parametric/StartRecord.hpp>

namespace harmos::parametric {
namespace {

TEST(StartRecord, TriesWhatItKnowsNothingOf) {
  StartRecord record;
  EXPECT_EQ(record.coldStages(), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(record.favoursWarm(0.5));
  record.addCold(20);
  for (int i = 0; i < 3; ++i) record.addWarm(0.5, 40);
  EXPECT_TRUE(record.favoursWarm(0.5));
  record.addWarm(0.5, 40);
  EXPECT_FALSE(record.favoursWarm(0.5));
  EXPECT_FALSE(record.favoursWarm(0.7));
  EXPECT_TRUE(record.favoursWarm(0.1));
}

TEST(StartRecord, ComparesMeansOfTheLastTries) {
  StartRecord record;
  record.addCold(20);
  record.addCold(30);
  EXPECT_DOUBLE_EQ(record.coldStages(), 25.0);
  for (int i = 0; i < 10; ++i) record.addWarm(0.1, 40);
  for (int i = 0; i < 8; ++i) record.addWarm(0.1, 2);
  EXPECT_TRUE(record.favoursWarm(0.1));  // 176 / 12
  for (int i = 0; i < 4; ++i) record.addWarm(0.1, 60);
  EXPECT_TRUE(record.favoursWarm(0.1));  // 256 / 12
  record.addWarm(0.1, 60);
  EXPECT_FALSE(record.favoursWarm(0.1));  // 314 / 12
}

TEST(StartRecord, LooksOnlyAtWhatWasAtLeastAsNear) {
  StartRecord record;
  record.addCold(20);
  for (int i = 0; i < 4; ++i) record.addWarm(0.1, 2);
  for (int i = 0; i < 4; ++i) record.addWarm(0.8, 50);
  EXPECT_TRUE(record.favoursWarm(0.1));
  EXPECT_FALSE(record.favoursWarm(0.8));
  EXPECT_TRUE(record.favoursWarm(0.05));
}

TEST(StartRecord, TriesAgainNowAndThen) {
  StartRecord record;
  record.addCold(20);
  for (int i = 0; i < 4; ++i) record.addWarm(0.5, 40);
  std::vector<int> tries;
  for (int i = 1; i <= 60; ++i) {
    if (!record.favoursWarm(0.5)) continue;
    tries.push_back(i);
    record.addWarm(0.5, 40);
  }
  EXPECT_EQ(tries, (std::vector<int>{8, 24, 40, 56}));
}

}  // namespace
}  // namespace harmos::parametric
