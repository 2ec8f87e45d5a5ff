#include <gtest/gtest.h>

#include <harmos/scene/detail/History.hpp>

namespace harmos::scene {
namespace {

TEST(History, TableIsLinearBetweenAndConstantOutside) {
  input::Parameters table("table");
  table.set("Type", std::string("Table"))
      .set("Times", std::vector<double>{1, 2, 4})
      .set("Values", std::vector<double>{0, 1, -1});
  input::ErrorList errors;
  EXPECT_EQ(historyFactors(table, {0, 1, 1.5, 2, 3, 4, 9}, errors), (std::vector<double>{0, 0, 0.5, 1, 0, -1, -1}));
  EXPECT_EQ(errors.count(), 0);
}

TEST(History, RampGrowsFromStartToEnd) {
  input::Parameters ramp("ramp");
  ramp.set("Type", std::string("Ramp")).set("Start", 1.0).set("End", 3.0);
  input::ErrorList errors;
  EXPECT_EQ(historyFactors(ramp, {0, 1, 2, 3, 4}, errors), (std::vector<double>{0, 0, 0.5, 1, 1}));
  EXPECT_EQ(errors.count(), 0);
  ramp.set("End", 1.0);
  historyFactors(ramp, {0}, errors);
  EXPECT_EQ(errors.count(), 1);
}

TEST(History, FormulaIsTakenAtEveryTime) {
  input::Parameters wave("wave");
  wave.set("Type", std::string("Formula")).set("Formula", std::string("t < 2 ? t^2 : 4 - t"));
  input::ErrorList errors;
  EXPECT_EQ(historyFactors(wave, {0, 1, 1.5, 2, 5}, errors), (std::vector<double>{0, 1, 2.25, 2, -1}));
  EXPECT_EQ(errors.count(), 0);
  wave.set("Formula", std::string("sqrt(1 - t)"));  // has no value at 2
  EXPECT_EQ(historyFactors(wave, {0, 1, 2}, errors).size(), 3U);
  EXPECT_EQ(errors.count(), 1);
  wave.set("Formula", std::string("2 * x"));
  historyFactors(wave, {0, 1, 2}, errors);
  EXPECT_EQ(errors.count(), 2);
}

}  // namespace
}  // namespace harmos::scene
