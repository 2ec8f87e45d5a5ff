#include <harmos/input/Formula.hpp>

#include <algorithm>
#include <cctype>
#include <cfenv>
#include <cmath>
#include <string_view>

#include <muParser.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/input/detail/KnownValue.hpp>

namespace harmos::input {

struct Formula::Parser {
  mu::Parser engine;
  std::vector<std::string> names;
  std::vector<double> values;  // the engine holds their addresses
};

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& what, const std::string& repair) {
  throw base::Error("the formula " + base::quoted(text) + " " + what + "\n  " + repair, base::ExitCode::input);
}

/// Whether a "=" stands by itself: to muParser an assignment, which as a condition would always hold.
bool assigns(const std::string& text) {
  constexpr std::string_view before = "=<>!";
  for (auto at = text.find('='); at != std::string::npos; at = text.find('=', at + 1)) {
    if (at + 1 < text.size() && text[at + 1] == '=') {
      ++at;
    } else if (at == 0 || before.find(text[at - 1]) == std::string_view::npos) {
      return true;
    }
  }
  return false;
}

}  // namespace

Formula::Formula(const std::string& text, const std::vector<std::string>& names) : Formula(text, names, Words()) {}

Formula::Formula(const std::string& text, const std::vector<std::string>& names, const Words& words)
    : text_(text), parser_(std::make_unique<Parser>()) {
  parser_->names = names;
  parser_->values.resize(names.size());
  if (assigns(text)) refuse(text, "assigns a value.", "Write == to compare.");
  try {
    for (std::size_t i = 0; i < names.size(); ++i) parser_->engine.DefineVar(names[i], &parser_->values[i]);
    parser_->engine.SetExpr(text);
    for (const auto& used : parser_->engine.GetUsedVar()) {
      if (std::find(names.begin(), names.end(), used.first) != names.end()) continue;
      refuse(text, "uses " + base::quoted(used.first) + ", which is no " + words.one + ".",
             base::suggestName(used.first, names, words.many));
    }
    parser_->engine.Eval();
    if (parser_->engine.GetNumResults() > 1) {
      refuse(text, "has a comma outside of a function, which makes a list.", "Write a decimal point, such as 0.5.");
    }
  } catch (const mu::Parser::exception_type& error) {
    throw base::Error(
        base::quoted(text) + " is not a formula: " + error.GetMsg() + "\n  Write for example " + words.example + ".",
        base::ExitCode::input);
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

std::vector<std::string> Formula::variables() const {
  const auto used = parser_->engine.GetUsedVar();
  std::vector<std::string> result;
  for (const std::string& name : parser_->names) {
    if (used.count(name) > 0) result.push_back(name);
  }
  return result;
}

double Formula::evaluate(const std::vector<double>& values) const {
  parser_->values.assign(values.begin(), values.end());
  // A comparison with NaN is false, so that the result does not tell of operations without a value.
  std::feclearexcept(FE_INVALID);
  double result = 0.0;
  try {
    result = parser_->engine.Eval();
  } catch (const mu::Parser::exception_type& error) {
    throw base::Error("the formula " + base::quoted(text_) + " has no value: " + error.GetMsg(), base::ExitCode::input);
  }
  const bool isInvalid = std::fetestexcept(FE_INVALID) != 0;
  if (!isInvalid && std::isfinite(result)) return result;
  std::vector<std::string> given;
  for (const std::string& name : variables()) {
    const auto at = std::find(parser_->names.begin(), parser_->names.end(), name) - parser_->names.begin();
    given.push_back(name + " = " + base::toText(values[at]));
  }
  const std::string place = given.empty() ? "" : " at " + base::joinNames(given);
  if (!isInvalid) {
    throw base::Error("the formula " + base::quoted(text_) + " has no finite value" + place + ".",
                      base::ExitCode::input);
  }
  refuse(text_, "has no value" + place + ": it takes a root, a logarithm or the like where there is none.",
         "Write for example \"mu > 1 ? sqrt(mu - 1) < 2 : 0\"; && and || compute both sides always.");
}

double Formula::whatever(const std::vector<double>& values) const {
  return knownValue(text_, parser_->names, values);
}

double* Formula::slots() const {
  return parser_->values.data();
}

double Formula::atSlots() const {
  return parser_->engine.Eval();
}

bool isFormulaName(const std::string& name) {
  const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (name.empty() || !isLetter(name.front())) return false;
  if (!std::all_of(name.begin(), name.end(), [&](char c) { return isLetter(c) || isDigit(c); })) return false;
  const mu::Parser parser;
  return parser.GetFunDef().count(name) == 0 && parser.GetConst().count(name) == 0;
}

}  // namespace harmos::input
