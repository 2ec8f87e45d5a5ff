#pragma once

#include <functional>
#include <string>

namespace harmos::latin {

/// A number that the laws or the loads of an assembly depend on, of which derivatives of responses are wanted.
struct ModelParameter {
  /// Where differences are taken: on both sides of the value, or on the one side on which values are admissible, where
  /// the derivative is that towards there.
  enum class Side { both, above, below };

  std::string name;    ///< for messages and results
  double value = 0.0;  ///< at which the assembly was solved, in a unit of its own
  /// >= 0, in the same unit: differences are taken as far as this, or twice that on one side. A millionth of the value
  /// leaves about ten digits of a smooth law. 0: as far as moves the state by a hundred-thousandth, where the value is
  /// 0 and tells nothing.
  double step = 0.0;
  /// Puts a value into the assembly: exchanges laws for others of their kind, or writes loads of bodies. Nothing else
  /// may change, and after set(value) all is as it was. Called alike on every rank.
  std::function<void(double)> set;
  Side side = Side::both;  ///< see Side
};

}  // namespace harmos::latin
