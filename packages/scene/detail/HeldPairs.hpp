#pragma once

#include <harmos/input/ErrorList.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/detail/HeldNodes.hpp>
#include <harmos/scene/detail/LawPlaces.hpp>

namespace harmos::scene {

/// Reports to `errors` laws that ask for a jump where boundaries hold all nodes of a pair at another one, at any load
/// step: rigid bonds that prescribe it, in all their directions, and laws that forbid some along the normal, such as
/// contact, also with the ground. No displacement obeys both, and tractions would grow without end.
///
/// Laws are asked, whatever they are called (AskedJumps.hpp). Springs give way and contradict nothing; laws of whole
/// faces are left out, and those of boundaries that hold nodes: HeldNodes::conflicts() compares these.
void checkHeldPairs(const Scene& scene, const LawPlaces& places, const HeldNodes& held, input::ErrorList& errors);

}  // namespace harmos::scene
