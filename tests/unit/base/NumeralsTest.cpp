#include <gtest/gtest.h>

#include <harmos/base/Numerals.hpp>

namespace harmos::base {
namespace {

TEST(Numerals, TextReadsBackExactly) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -2.5e17, 5e-324}) EXPECT_EQ(parseNumber(toText(value)), value);
  EXPECT_EQ(toText(0.001), "0.001");
  EXPECT_EQ(toText(3.0), "3");
}

TEST(Numerals, WholeTextOnly) {
  EXPECT_EQ(parseNumber(" +1.5e2 "), 150.0);
  EXPECT_EQ(parseNumber("-7"), -7.0);
  EXPECT_FALSE(parseNumber("+-1"));
  EXPECT_FALSE(parseNumber("1e3x"));
  EXPECT_EQ(parseInteger("-12"), -12);
  EXPECT_FALSE(parseInteger("2147483648"));
}

TEST(Numerals, Items) {
  EXPECT_EQ(parseItems("{a b, c}"), (std::vector<std::string>{"a b", "c"}));
  EXPECT_EQ(parseItems("{ }"), std::vector<std::string>{});
  EXPECT_FALSE(parseItems("{a,}"));
}

}  // namespace
}  // namespace harmos::base
