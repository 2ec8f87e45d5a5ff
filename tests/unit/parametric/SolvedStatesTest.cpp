#include <limits>

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

}  // namespace
}  // namespace harmos::parametric
