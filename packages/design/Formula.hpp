#pragma once

#include <memory>
#include <string>
#include <vector>

namespace harmos::design {

/// A formula over the parameters of a study, in the syntax of muParser: + - * / ^, comparisons, &&, ||, ?:, sqrt, min
/// and the like.
class Formula {
 public:
  /// `names` are the variables that it may use. Throws base::Error (input) when the text is no formula, uses others or
  /// assigns a value.
  Formula(const std::string& text, const std::vector<std::string>& names);
  ~Formula();
  /// The other one can only be destroyed or assigned to afterwards.
  Formula(Formula&&) noexcept;
  /// The same.
  Formula& operator=(Formula&&) noexcept;

  /// As given.
  const std::string& text() const { return text_; }
  /// Those of the names that occur in it, in their order.
  std::vector<std::string> variables() const;
  /// `values` of the names, one for each, in their order. Not for use by several threads. Throws base::Error (input)
  /// when the result, or what it is computed from, is no number or the result is infinite.
  double evaluate(const std::vector<double>& values) const;

 private:
  struct Parser;
  std::string text_;
  std::unique_ptr<Parser> parser_;
};

/// Whether a name can stand in a formula: letters, digits and underscores, no digit first, and no function or
/// constant of muParser.
bool isFormulaName(const std::string& name);

}  // namespace harmos::design
