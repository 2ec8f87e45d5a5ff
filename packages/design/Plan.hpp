#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <harmos/design/Configuration.hpp>
#include <harmos/design/Design.hpp>
#include <harmos/input/Formula.hpp>

namespace harmos::design {

/// A parameter of a study: free, then the design chooses its values, or derived from the others by a formula.
struct PlannedParameter {
  Axis axis;            // its name alone counts when it is derived
  std::string formula;  // empty: free
  std::string where;    // the place of the formula in the input
};

/// A demand on the parameters: configurations where the formula is 0 (false) are left out.
struct Condition {
  std::string name;     // as in leftOut() and messages
  std::string formula;  // over all parameters, see input::Formula
  std::string where;    // its place in the input
};

/// All configurations of a study: the points of a design, completed by derived parameters and sifted by conditions.
class Plan {
 public:
  /// Throws base::Error (input), beginning with the place of the parameter or condition, when a formula is wrong or two
  /// parameters derive from each other.
  Plan(std::vector<PlannedParameter> parameters, const std::vector<Condition>& conditions);

  /// Numbers the configurations from 1; values are in the order of the parameters. Throws base::Error (input),
  /// beginning with a place, when the conditions leave none or a formula has no value; without a place, when the design
  /// has no point.
  std::vector<Configuration> configurations(const Design& design);
  /// The values of all parameters for those of the free ones, both in the order of the parameters and in their units;
  /// nothing when a condition leaves the point out, which leftOut() counts. Throws
  /// base::Error (input), beginning with a place, when a formula has no value.
  std::optional<std::vector<double>> complete(const std::vector<double>& point);
  /// Of the free parameters, in their order: the columns of a design.
  std::vector<Axis> axes() const;
  /// By name how many points of the last design each condition left out, and of those that were completed since; the
  /// first that is violated counts.
  const std::vector<std::pair<std::string, int>>& leftOut() const { return leftOut_; }

 private:
  struct Derived {
    std::size_t parameter;
    input::Formula formula;
  };
  struct Sieve {
    std::string where;
    input::Formula formula;
  };
  std::string whyNoneIsLeft(std::size_t points) const;

  std::vector<PlannedParameter> parameters_;
  std::vector<Derived> derived_;  // each after those that it needs
  std::vector<Sieve> conditions_;
  std::vector<std::pair<std::string, int>> leftOut_;
};

}  // namespace harmos::design
