#pragma once

#include <harmos/statics/RigidAssembly.hpp>

namespace harmos::statics {

/// Whether friction may help to balance the loads.
enum class Friction {
  full,  ///< |t_t| <= mu |t_n|, in space the round cone itself
  none   ///< what friction adds is left out
};

/// What admissible tractions leave of the loads of a rigid assembly, at best.
struct Balance {
  bool isKnown = false;            ///< false: the programme could not be solved; nothing is claimed
  double residual = 0.0;           ///< sum of absolute resultants that are left, moments over sizes, over the scale [-]
  std::vector<Wrench> unbalanced;  ///< what is left, of the bodies
  /// Of the bodies, where there is a residual: the loads work along them, and no admissible traction does so against
  /// them. The largest translation, or rotation times size, is 1 [length].
  std::vector<Motion> motions;
};

/// The least residual of loads (about the centres of the bodies, one wrench each), tractions times areas and couplings;
/// `scale` [force] is the size of the loads, such as the sum of absolute nodal forces.
///
/// A linear programme over the tractions. The cone of friction in space is met exactly by adding the rays along which
/// the motion of the last programme slides (column generation): the forces that balance lie within the cones, and the
/// motion that shows the contrary is resisted by no vector of them (Farkas' lemma), both to round-off. An elastic body
/// takes every balanced system of forces: that forces exist holds of elastic bodies just as well. Not collective.
Balance findBalance(const RigidAssembly& assembly, const std::vector<Wrench>& loads, double scale, Friction friction);

}  // namespace harmos::statics
