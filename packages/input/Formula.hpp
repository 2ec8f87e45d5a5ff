#pragma once

#include <memory>
#include <string>
#include <vector>

namespace harmos::input {

/// A formula over named variables, in the syntax of muParser: + - * / ^, comparisons, &&, ||, ?:, sqrt, min
/// and the like.
class Formula {
 public:
  /// What messages say of its variables.
  struct Words {
    std::string one = "parameter";                                     ///< what a variable is
    std::string many = "Parameters";                                   ///< what a list of them is
    std::string example = "\"2 * mu\" or \"preload_1 >= preload_2\"";  ///< formulas
  };

  /// `names` are the variables that it may use. Throws base::Error (input) when the text is no formula, uses others or
  /// assigns a value.
  Formula(const std::string& text, const std::vector<std::string>& names, const Words& words);
  /// The same over the parameters of a study.
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
  /// Its value whatever the names are that are not known, such as 0 of "0 * x": `values` of the names in their order,
  /// NaN where one is not known. NaN: it may depend on them.
  double whatever(const std::vector<double>& values) const;
  /// Where the values of the names are kept for atSlots(), in their order; owned by the formula, and valid as long as
  /// it is, also when it is moved.
  double* slots() const;
  /// Its value at what the slots hold, unchecked and fast: what is no number comes back as it is. Not for use by
  /// several threads.
  double atSlots() const;

 private:
  struct Parser;
  std::string text_;
  std::unique_ptr<Parser> parser_;
};

/// Whether a name can stand in a formula: letters, digits and underscores, no digit first, and no function or
/// constant of muParser.
bool isFormulaName(const std::string& name);

}  // namespace harmos::input
