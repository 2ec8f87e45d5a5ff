#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/input/Formula.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/NodeArrays.hpp>
#include <harmos/laws/OutputField.hpp>

namespace harmos::laws {

/// Tractions and histories as formulas of the jump, see the law "Formula". Not for use by several threads.
class FormulaGraph {
 public:
  /// Declares the formulas, their constants and their histories.
  static void describe(input::ParameterSpec& spec);

  /// Reads what describe() declares. Throws one base::Error (input) for all formulas and names that are none.
  explicit FormulaGraph(const input::Parameters& parameters);

  /// Names of the histories, in the order of the input.
  const std::vector<std::string>& histories() const { return histories_; }
  /// The histories as fields of the results.
  const std::vector<OutputField>& outputs() const { return outputs_; }
  /// Whether every component of the traction follows from the same component of the jump alone.
  bool isUncoupled() const { return isUncoupled_; }

  /// Which components of the traction, n, t1, t2, are 0 whatever the jump: the number 0, or what its product makes 0.
  const std::array<bool, 3>& areZero() const { return areZero_; }

  /// Names of the fields that formulas may use, in the order of the input.
  const std::vector<std::string>& fields() const { return fields_; }

  /// What formulas see of a point from now on: place, time, gap, the histories at the end of the load step before, and
  /// the values of the fields() there.
  void goTo(const NodeContext& at, const double* old, const std::vector<double>& fields);
  /// The traction [stress] at a jump [length]; NaN where a formula has no value.
  base::Vector3 traction(const base::Vector3& jump);
  /// Component `c` of the traction where the graph isUncoupled(), at that component of the jump.
  double component(std::size_t c, double jump);
  /// Writes the histories at the end of the load step, which belong to a jump.
  void update(const base::Vector3& jump, double* now);

 private:
  /// A formula with what it needs of others.
  struct Expression {
    input::Formula formula;
    std::vector<std::size_t> histories;  // whose values at the end of the load step it uses, and they again, in order
    std::array<bool, 3> hasJump{};       // whether it looks at this component, by itself or by these histories
    bool hasPlace = false;               // whether it looks at place, time or gap
  };

  Expression compiled(const input::Parameters& list, const std::string& entry, std::size_t known) const;
  void place(Expression& expression, const NodeContext& at, const double* old, const std::vector<double>& fields) const;
  double valueOf(Expression& expression, const base::Vector3& jump);
  double alone(Expression& expression, const base::Vector3& jump);

  std::vector<std::string> histories_;
  std::vector<OutputField> outputs_;
  std::vector<std::string> fields_;
  std::vector<std::string> names_;     // of all that formulas may use, in the order of their slots
  std::vector<double> constants_;      // values of the last of them
  std::vector<Expression> updates_;    // of the histories
  std::vector<Expression> tractions_;  // n, t1, t2
  std::vector<double> now_;            // histories at the end of the load step, as far as they are known
  bool isUncoupled_ = false;
  std::array<bool, 3> areZero_{};
};

}  // namespace harmos::laws
