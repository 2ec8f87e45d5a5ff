#include <harmos/input/detail/KnownValue.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <muParser.h>

namespace harmos::input {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double times(double a, double b) {
  // Also of a number that is not known.
  const bool isNothing = (a == 0.0 && !std::isinf(b)) || (b == 0.0 && !std::isinf(a));
  return isNothing ? 0.0 : a * b;
}

/// A comparison, which is false of NaN and would look known.
template <class Compare>
double compare(double a, double b, const Compare& holds) {
  return std::isnan(a) || std::isnan(b) ? unknown : static_cast<double>(holds(a, b));
}

double bothHold(double a, double b) {
  if (a == 0.0 || b == 0.0) return 0.0;
  return std::isnan(a) || std::isnan(b) ? unknown : 1.0;
}

double oneHolds(double a, double b) {
  if ((a != 0.0 && !std::isnan(a)) || (b != 0.0 && !std::isnan(b))) return 1.0;
  return std::isnan(a) || std::isnan(b) ? unknown : 0.0;
}

bool isAnyUnknown(const double* values, int count) {
  return std::any_of(values, values + count, [](double value) { return std::isnan(value); });
}

/// The operators of muParser, but for "?:" and assignments, with its priorities.
void defineOperators(mu::Parser& engine) {
  engine.EnableBuiltInOprt(false);
  const auto define = [&](const char* name, mu::fun_type2 function, unsigned priority,
                          mu::EOprtAssociativity associativity = mu::oaLEFT) {
    engine.DefineOprt(name, function, priority, associativity);
  };
  define(
      "+", [](double a, double b) { return a + b; }, mu::prADD_SUB);
  define(
      "-", [](double a, double b) { return a - b; }, mu::prADD_SUB);
  define("*", times, mu::prMUL_DIV);
  define(
      "/", [](double a, double b) { return a / b; }, mu::prMUL_DIV);
  define(
      "^", [](double a, double b) { return std::pow(a, b); }, mu::prPOW, mu::oaRIGHT);
  define(
      "<=", [](double a, double b) { return compare(a, b, std::less_equal<>()); }, mu::prCMP);
  define(
      ">=", [](double a, double b) { return compare(a, b, std::greater_equal<>()); }, mu::prCMP);
  define(
      "!=", [](double a, double b) { return compare(a, b, std::not_equal_to<>()); }, mu::prCMP);
  define(
      "==", [](double a, double b) { return compare(a, b, std::equal_to<>()); }, mu::prCMP);
  define(
      "<", [](double a, double b) { return compare(a, b, std::less<>()); }, mu::prCMP);
  define(
      ">", [](double a, double b) { return compare(a, b, std::greater<>()); }, mu::prCMP);
  define("&&", bothHold, mu::prLAND);
  define("||", oneHolds, mu::prLOR);
}

/// The functions that would make a number of NaN.
void defineFunctions(mu::Parser& engine) {
  engine.DefineFun("sign", [](double x) { return std::isnan(x) ? unknown : static_cast<double>((x > 0) - (x < 0)); });
  engine.DefineFun("min", [](const double* values, int count) {
    return isAnyUnknown(values, count) ? unknown : *std::min_element(values, values + count);
  });
  engine.DefineFun("max", [](const double* values, int count) {
    return isAnyUnknown(values, count) ? unknown : *std::max_element(values, values + count);
  });
}

}  // namespace

double knownValue(const std::string& text, const std::vector<std::string>& names, std::vector<double> values) {
  if (text.find('?') != std::string::npos) return unknown;
  mu::Parser engine;
  defineOperators(engine);
  defineFunctions(engine);
  for (std::size_t i = 0; i < names.size(); ++i) engine.DefineVar(names[i], &values[i]);
  engine.SetExpr(text);
  return engine.Eval();
}

}  // namespace harmos::input
