#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/input/Formula.hpp>

namespace harmos::input {
namespace {

std::string messageOf(const std::string& text) {
  try {
    Formula(text, {"mu", "preload"}).evaluate({0.0, 1.0});
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::input);
    return error.what();
  }
  return "accepted";
}

TEST(Formula, Computes) {
  const Formula formula("preload >= 2 * mu && mu > 0 ? sqrt(preload) : -1", {"mu", "preload"});
  EXPECT_EQ(formula.evaluate({0.5, 4.0}), 2.0);
  EXPECT_EQ(formula.evaluate({3.0, 4.0}), -1.0);
  EXPECT_EQ(Formula("2*preload", {"mu", "preload"}).variables(), std::vector<std::string>{"preload"});
}

TEST(Formula, KnowsWhatDoesNotDependOnWhatIsUnknown) {
  const double unknown = std::nan("");
  const auto whatever = [](const std::string& text, double mu, double preload) {
    return Formula(text, {"mu", "preload"}).whatever({mu, preload});
  };
  for (const char* zero : {"0", "2 - 2", "0 * mu", "mu * 0.0", "-0 * mu ^ 2 + (1 - 1) * sqrt(mu)", "mu * preload * 0",
                           "0 * (mu > 1)", "0 && mu", "min(0, 1) * mu", "0 * min(mu, 1)"})
    EXPECT_EQ(whatever(zero, unknown, unknown), 0.0) << zero;
  EXPECT_EQ(whatever("preload * mu", unknown, 0.0), 0.0);
  EXPECT_EQ(whatever("2 + preload * mu + -2 ^ 2 * 3 ^ 1 ^ 2", unknown, 0.0), -10.0);
  EXPECT_EQ(whatever("(preload < 1 || mu) + (preload == 0)", unknown, 0.0), 2.0);
  for (const char* open :
       {"mu", "1e-300 * mu", "min(0, mu)", "max(mu, 0)", "mu > 1e9", "sign(mu)", "mu && 1", "mu || 0",
        "mu < 1e9 ? 0 : 1", "mu - mu", "0 / mu", "0 ^ mu", "sum(0, mu)", "abs(mu)", "rint(mu)"})
    EXPECT_TRUE(std::isnan(whatever(open, unknown, 0.0))) << open;
}

TEST(Formula, SaysWhatIsWrong) {
  EXPECT_EQ(messageOf("2 * prelaod"),
            "the formula \"2 * prelaod\" uses \"prelaod\", which is no parameter.\n  Did you mean \"preload\"? "
            "Parameters: mu, preload.");
  EXPECT_EQ(messageOf("preload / mu"), "the formula \"preload / mu\" has no finite value at mu = 0, preload = 1.");
  EXPECT_EQ(messageOf("sqrt(mu - 1) > 0"),
            "the formula \"sqrt(mu - 1) > 0\" has no value at mu = 0: it takes a root, a logarithm or the like where "
            "there is none.\n  Write for example \"mu > 1 ? sqrt(mu - 1) < 2 : 0\"; && and || compute both sides "
            "always.");
  EXPECT_NE(messageOf("min(1, log(mu - 1))").find("has no value"), std::string::npos);
  EXPECT_NE(messageOf("2 *").find("\"2 *\" is not a formula: "), std::string::npos);
  EXPECT_NE(messageOf("").find("is not a formula"), std::string::npos);
}

TEST(Formula, RefusesAssignments) {
  EXPECT_EQ(messageOf("mu = 0.3"), "the formula \"mu = 0.3\" assigns a value.\n  Write == to compare.");
  EXPECT_NE(messageOf("mu += 1").find("assigns a value"), std::string::npos);
  EXPECT_EQ(messageOf("mu == 0.3 && mu <= 1 && mu >= 0 && mu != 2"), "accepted");
}

TEST(Formula, RefusesDecimalCommas) {
  const std::string rest =
      "\" has a comma outside of a function, which makes a list.\n  Write a decimal point, such as 0.5.";
  EXPECT_EQ(messageOf("mu > 0,25"), "the formula \"mu > 0,25" + rest);
  EXPECT_EQ(messageOf("-100,5 * mu"), "the formula \"-100,5 * mu" + rest);
  EXPECT_EQ(Formula("min(mu, preload) + max(1, 2)", {"mu", "preload"}).evaluate({3.0, 4.0}), 5.0);
}

TEST(Formula, NamesAreIdentifiers) {
  EXPECT_TRUE(isFormulaName("preload_1"));
  EXPECT_FALSE(isFormulaName(""));
  EXPECT_FALSE(isFormulaName("1st"));
  EXPECT_FALSE(isFormulaName("Young's Modulus"));
  EXPECT_FALSE(isFormulaName("sqrt"));
  EXPECT_FALSE(isFormulaName("_pi"));
}

}  // namespace
}  // namespace harmos::input
