#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <harmos/base/ShareOut.hpp>

namespace harmos::base {
namespace {

std::vector<double> loadsOf(const std::vector<double>& cost, const std::vector<int>& rank, std::vector<double> load) {
  for (std::size_t i = 0; i < cost.size(); ++i) load.at(rank[i]) += cost[i];
  return load;
}

TEST(ShareOut, GivesTheLargestFirst) {
  EXPECT_EQ(shareOut({1, 5, 4, 2}, {0, 0}), (std::vector<int>{0, 0, 1, 1}));
  EXPECT_TRUE(shareOut({}, {0, 0}).empty());
  EXPECT_EQ(shareOut({3, 1}, {0}), (std::vector<int>{0, 0}));
}

TEST(ShareOut, CountsWhatRanksHaveToDoBesides) {
  EXPECT_EQ(shareOut({2, 2}, {5, 0, 1}), (std::vector<int>{1, 2}));
}

TEST(ShareOut, LeavesPiecesWithTheirOwnersWhereNobodyHasLess) {
  EXPECT_EQ(shareOut({2, 2, 2}, {0, 0, 0}, {2, 1, 0}), (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(shareOut({2, 2}, {0.1, 0}, {0, 0}), (std::vector<int>{0, 1}));
}

/// The least possible largest load, by trying all.
double leastPossible(const std::vector<double>& cost, std::vector<double>& load, std::size_t piece = 0) {
  if (piece == cost.size()) return *std::max_element(load.begin(), load.end());
  double least = std::numeric_limits<double>::infinity();
  for (double& one : load) {
    one += cost[piece];
    least = std::min(least, leastPossible(cost, load, piece + 1));
    one -= cost[piece];
  }
  return least;
}

TEST(ShareOut, IsWithinAThirdOfTheBest) {
  std::mt19937 random;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> cost(random() % 8), none(1 + random() % 3, 0.0);
    for (double& one : cost) one = 1.0 + random() % 100;
    const std::vector<double> load = loadsOf(cost, shareOut(cost, none), none);
    EXPECT_LE(*std::max_element(load.begin(), load.end()), 4.0 / 3.0 * leastPossible(cost, none));
  }
}

}  // namespace
}  // namespace harmos::base
