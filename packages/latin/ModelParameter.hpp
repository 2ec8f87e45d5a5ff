#pragma once

#include <functional>
#include <string>

namespace harmos::latin {

/// A number that the laws or the loads of an assembly depend on, of which derivatives of responses are wanted.
struct ModelParameter {
  std::string name;    ///< for messages and results
  double value = 0.0;  ///< at which the assembly was solved, in a unit of its own
  /// > 0, in the same unit: differences are taken this far on both sides. A millionth of the value, or of what is
  /// usual where that is 0, leaves about ten digits of a smooth law.
  double step = 0.0;
  /// Puts a value into the assembly: exchanges laws for others of their kind, or writes loads of bodies. Nothing else
  /// may change, and after set(value) all is as it was. Called alike on every rank.
  std::function<void(double)> set;
};

}  // namespace harmos::latin
