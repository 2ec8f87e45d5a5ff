#include <gtest/gtest.h>

#include <harmos/base/DisjointSets.hpp>

namespace harmos::base {
namespace {

TEST(DisjointSets, AreJoinedUnderTheRootOfTheSecond) {
  DisjointSets sets(4);
  sets.join(0, 1);
  sets.join(2, 3);
  EXPECT_EQ(sets.root(0), 1);
  EXPECT_NE(sets.root(0), sets.root(2));
  sets.join(0, 2);
  for (int one = 0; one < 4; ++one) EXPECT_EQ(sets.root(one), 3) << one;
}

TEST(DisjointSets, GrowByNumbersOfTheirOwn) {
  DisjointSets sets(1);
  EXPECT_EQ(sets.add(), 1);
  EXPECT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets.root(1), 1);
  sets.join(0, 0);
  EXPECT_EQ(sets.root(0), 0);
}

}  // namespace
}  // namespace harmos::base
