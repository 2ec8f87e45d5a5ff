#pragma once

#include <vector>

#include <harmos/mortar/HeldDirections.hpp>
#include <harmos/mortar/JoinedSurface.hpp>

namespace harmos::mortar {

/// Per point, whether boundaries hold both sides there along the surface, but for nodes beside it that one side sees,
/// too: next to a plane of symmetry. What the tractions of such a point do along it is next to nothing, so that hardly
/// anything determines them; where neither side sees more than held nodes it is nothing at all, which does no harm.
std::vector<bool> findDoublyHeld(const JoinedSurface& surface, const HeldDirections& held);

}  // namespace harmos::mortar
