#pragma once

#include <harmos/latin/EquilibriumCheck.hpp>

namespace harmos::latin {

/// True when nothing stops the body of `imbalance` on its way along the force (or about the moment) that is not
/// balanced: then the interface laws cannot carry the load, whatever the iteration does. Collective.
///
/// The body is moved so far that interfaces as stiff as the search direction would answer with a million times the
/// imbalance, and the local stage tells what they answer. A contact that the way meets at a grazing angle is slid
/// along; bodies that resist are moved as well; where the ground resists, the body is held. `image` must be T(alpha)
/// and is so again afterwards; costs one linear stage per body or turn, and one.
bool movesFreely(const Imbalance& imbalance, FixedPoint& fixedPoint, const base::Matrix& alpha, base::Matrix& image);

}  // namespace harmos::latin
