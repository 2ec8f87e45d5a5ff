#pragma once

#include <string>
#include <vector>

#include <harmos/latin/Iterate.hpp>

namespace harmos::latin {

/// Resultant of f - f^ on one body, or on several that move as one, at one load step: what the interface laws fail to
/// carry. Of bodies that eliminated boundaries hold, the part that works in the motions that they leave free.
struct Imbalance {
  int body = -1;           ///< position in the assembly, of several the first; -1: there is none
  int step = 0;            ///< column of the state, a load step when all are selected
  base::Vector3 force{};   ///< [force], f - f^: the part of the loads that finds no reaction
  base::Vector3 moment{};  ///< [force length], about the body's centre
  base::Vector3 centre{};  ///< [length]
  double arm = 0.0;        ///< largest extent of a body [length]
  double load = 0.0;       ///< sum of the absolute forces on the body at this step [force]
  double relative = 0.0;   ///< |force|, or |moment| / size of the body, over the largest sum of forces on the body [-]
};

/// The body and load step with the largest relative imbalance of those selected. `rigidBodies`: of every body a number
/// that those have in common which move as one, such as the pieces of a part, and are taken together, -1 for those that
/// cannot move and are left out; empty: each body by itself. The sum of forces on a body counts as `leastShare` [-] of
/// the largest on any at least: what is left of none is round-off, all of it out of balance. Collective.
///
/// f is in equilibrium with the body, f^ obeys the laws. Where an equilibrium exists both agree in the end; where none
/// does, the imbalance stays while everything else settles.
Imbalance largestImbalance(const Iterate& state, const std::vector<int>& rigidBodies = {}, double leastShare = 0.0);

/// One line for the user: part, step, force and moment in the units of the scene, which are not named.
std::string describe(const Imbalance& imbalance, const assembly::Assembly& assembly);

/// Why the laws cannot carry the loads, for the user. `hasForces`: forces that they admit would balance the loads.
std::string describeLack(const Imbalance& imbalance, const assembly::Assembly& assembly, bool hasForces);

}  // namespace harmos::latin
