#pragma once

#include <array>

#include <harmos/base/Vector3.hpp>

namespace harmos::benchmarks {

/// What a step of the semi-smooth Newton method asks of a contact pair: its jump (n, t1, t2) is free (open), wholly
/// held (stick), or held along n with friction q = stiffness (w_t - from) + pull p + constant (slip), p the
/// pressure [force].
struct PairEquation {
  enum class Motion { stick, slip, open };
  Motion motion = Motion::stick;
  base::Vector3 held{};                            ///< what held components become [length]
  std::array<double, 2> from;                      ///< of slip only: w_t of the linearisation [length]
  std::array<std::array<double, 2>, 2> stiffness;  ///< of slip only [force/length]
  std::array<double, 2> pull;                      ///< of slip only [-]
  std::array<double, 2> constant;                  ///< of slip only [force]
};

/// Coulomb's law with unilateral contact, linearised with the slip matrix of Hueeber, Stadler, Wohlmuth (2008),
/// SIAM J. Sci. Comput. 30, doi:10.1137/060671061, which stays stable where the exact derivative makes the method
/// cycle.
///
/// force: on the jump, (p, -q); before: the jump at the end of the last load step; scale > 0 weighs jumps against
/// forces [force/length] and does not change the solution.
PairEquation linearise(const base::Vector3& jump, const base::Vector3& force, const base::Vector3& before,
                       double friction, double scale);

/// How far a force is from the one that the law gives for force and jump together [force]; 0 at a solution.
base::Vector3 violation(const base::Vector3& jump, const base::Vector3& force, const base::Vector3& before,
                        double friction, double scale);

}  // namespace harmos::benchmarks
