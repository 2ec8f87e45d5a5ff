#pragma once

#include <memory>
#include <string>
#include <vector>

namespace harmos::design {

/// A formula over the parameters of a study, in the syntax of muParser: + - * / ^, comparisons, &&, ||, ?:, sqrt, min
/// and the like.
class Formula {
 public:
  /// `names` are the variables that it may use. Throws base::Error (input) when the text is no formula or uses others.
  Formula(const std::string& text, const std::vector<std::string>& names);
  ~Formula();
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;

  const std::string& text() const { return text_; }
  /// Those of the names that occur in it, in their order.
  std::vector<std::string> variables() const;
  /// `values` of the names, in their order. Throws base::Error (input) when the result, or what it is computed from, is
  /// no number or the result is infinite.
  double evaluate(const std::vector<double>& values) const;

 private:
  struct Parser;
  std::string text_;
  std::unique_ptr<Parser> parser_;
};

/// Whether a name can stand in a formula: letters, digits and underscores, no digit first, and no function of formulas.
bool isFormulaName(const std::string& name);

}  // namespace harmos::design
