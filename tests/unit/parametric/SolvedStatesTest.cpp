#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include <harmos/parametric/SolvedStates.hpp>

namespace harmos::parametric {
namespace {

base::Matrix field(double value) {
  base::Matrix matrix(3, 2);
  matrix.putScalar(value);
  return matrix;
}

void add(SolvedStates& states, int id, const std::vector<double>& values) {
  states.widen(values);
  states.add(id, values, field(id), field(10.0 * id));
}

std::vector<int> ids(const SolvedStates& states, const std::vector<int>& positions) {
  std::vector<int> result;
  for (int position : positions) result.push_back(states.id(position));
  return result;
}

// The second parameter has a hundred times the range of the first.
TEST(SolvedStates, AreNearestInTheRangesOfTheParameters) {
  SolvedStates states(10);
  add(states, 1, {0.0, 0.0});
  add(states, 2, {1.0, 0.0});
  add(states, 3, {0.0, 100.0});
  add(states, 4, {0.0, 40.0});
  EXPECT_EQ(ids(states, states.nearest({0.1, 20.0}, 3)), (std::vector<int>{1, 4, 3}));
  EXPECT_EQ(states.nearest({0.1, 20.0}, 9).size(), 4u);
}

TEST(SolvedStates, KnowTheDistanceToTheNearest) {
  SolvedStates states(10);
  EXPECT_EQ(states.distance({0.0, 0.0}), std::numeric_limits<double>::infinity());
  states.widen({4.0, 100.0});
  add(states, 1, {0.0, 0.0});
  add(states, 2, {4.0, 0.0});
  EXPECT_DOUBLE_EQ(states.distance({1.2, 40.0}), 0.5);
}

TEST(SolvedStates, ReturnWhatWasStored) {
  SolvedStates states(10);
  add(states, 7, {1.0});
  states.add(7, {1.0}, field(0.5), field(0.25));
  ASSERT_EQ(states.count(), 1);
  base::Matrix alpha(3, 2), linear(3, 2);
  states.copy(0, alpha, linear);
  EXPECT_EQ(alpha(2, 1), 0.5);
  EXPECT_EQ(linear(0, 0), 0.25);
}

TEST(SolvedStates, DropOneOfTheClosestWhenFull) {
  SolvedStates states(3);
  add(states, 1, {0.0});
  add(states, 2, {1.0});
  add(states, 3, {1.1});
  add(states, 4, {3.0});
  EXPECT_EQ(ids(states, states.nearest({0.0}, 4)), (std::vector<int>{1, 3, 4}));
}

// Which one is dropped does not depend on what was known of the others: also after ranges have grown, and where a state
// was replaced.
TEST(SolvedStates, DropTheEarlierOfTheClosestPairEachTime) {
  constexpr std::size_t largest = 12;
  std::mt19937 random(3);
  SolvedStates states(largest);
  std::vector<std::pair<int, std::vector<double>>> expected;
  double range[2] = {0.0, 0.0}, least[2] = {1e9, 1e9};
  for (int id = 1; id <= 60; ++id) {
    const std::vector<double> values = {static_cast<double>(random() % 1000) * (id > 40 ? 3.0 : 1.0),
                                        static_cast<double>(random() % 1000)};
    const int chosen = id % 10 == 0 ? expected[random() % expected.size()].first : id;
    for (std::size_t p = 0; p < 2; ++p) {
      range[p] = std::max(range[p], values[p]);
      least[p] = std::min(least[p], values[p]);
    }
    add(states, chosen, values);
    const auto same =
        std::find_if(expected.begin(), expected.end(), [&](const auto& one) { return one.first == chosen; });
    if (same != expected.end()) expected.erase(same);
    if (expected.size() == largest) {
      std::pair<double, std::size_t> closest{1e9, 0};
      for (std::size_t i = 0; i < largest; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          double square = 0.0;
          for (std::size_t p = 0; p < 2; ++p) {
            const double difference = expected[i].second[p] - expected[j].second[p];
            square += difference * difference / ((range[p] - least[p]) * (range[p] - least[p]));
          }
          if (square < closest.first - 1e-12) closest = {square, j};
        }
      }
      expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(closest.second));
    }
    expected.emplace_back(chosen, values);
    ASSERT_EQ(states.count(), static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(states.id(static_cast<int>(i)), expected[i].first);
  }
}

}  // namespace
}  // namespace harmos::parametric
