#pragma once

#include <set>
#include <string>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/detail/MacroFactor.hpp>

namespace harmos::latin {

/// The softest motion of a macro problem that is not positive definite: which bodies take part, and why it is so soft.
///
/// Numbers of a chain that is held, but long, look like those of one that is not; so what is fixed to the ground by
/// laws that bear every traction is told apart by its joints.
class SoftestMotion {
 public:
  /// Collective. `modes`: motions of the interfaces, of which firstMode are the first unknowns.
  SoftestMotion(const assembly::Assembly& assembly, const std::vector<base::Matrix>& modes,
                const std::vector<int>& firstMode, const MacroFactor::NotPositiveDefinite& failure,
                const Teuchos::Comm<int>& comm);

  /// Whether all bodies are fixed to the ground and nothing but round-off makes the problem singular.
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
