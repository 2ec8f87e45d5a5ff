#pragma once

#include <set>
#include <string>
#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/latin/detail/MacroFactor.hpp>

namespace harmos::latin {

/// The softest motion of a macro problem that is not positive definite: which bodies take part, and why it is so soft.
///
/// Numbers of a chain that is held, but long, look like those of one that is not; so they are told apart by the
/// interfaces: in the macro problem each resists every jump by its search direction, whatever its law, so that bodies
/// are held which interfaces fix to each other and to the ground. Eliminated boundaries hold what their laws hold. What
/// laws bear else is asked of LoadBalance.
class SoftestMotion {
 public:
  /// Not collective: every rank gets the same. `modes`: motions of the interfaces, of which firstMode are the first
  /// unknowns.
  SoftestMotion(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated,
                const std::vector<base::Matrix>& modes, const std::vector<int>& firstMode,
                const MacroFactor::NotPositiveDefinite& failure);

  /// Whether interfaces fix all bodies to the ground, so that nothing but round-off makes the problem singular.
  bool isHeld() const { return loose_.empty() && !isIndefinite_; }
  /// Why there is no solution, naming some parts.
  [[noreturn]] void refuse() const;

 private:
  std::string namesOf(const std::set<int>& bodies) const;

  const assembly::Assembly& assembly_;
  std::set<int> moving_, loose_;  // bodies
  double eigenvalue_;
  bool isIndefinite_;
};

}  // namespace harmos::latin
