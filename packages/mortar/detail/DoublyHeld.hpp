#pragma once

#include <vector>

#include <harmos/mortar/HeldDirections.hpp>
#include <harmos/mortar/JoinedSurface.hpp>

namespace harmos::mortar {

/// Per point, whether boundaries hold both sides there along the surface, but for nodes beside it that one side sees,
/// too: next to a plane of symmetry. What the tractions of such a point do along it is next to nothing, so that hardly
/// anything determines them; where neither side sees more than held nodes it is nothing at all, which does no harm.
std::vector<bool> findDoublyHeld(const JoinedSurface& surface, const HeldDirections& held);

/// Where boundaries hold all that both sides see of a point in one direction along the surface, but for stray weights
/// on nodes that they hold otherwise, leaves these weights out of `surface.trace`: in thin sectors between planes of
/// symmetry, whose cells are trapezia, those on the other plane. A jump that is all but given would ask for a traction
/// without end.
void leaveOutStrayWeights(JoinedSurface& surface, const HeldDirections& held);

}  // namespace harmos::mortar
