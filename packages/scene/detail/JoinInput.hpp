#pragma once

#include <harmos/input/Parameters.hpp>
#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/mortar/JoinSurfaces.hpp>

namespace harmos::scene {

/// Declares the entries of an interface that say how meshes are joined that do not match.
void describeJoining(input::ParameterSpec& spec);

/// Whether all faces of an interface are to be joined by points, those that match as well: the user has chosen their
/// side, or how far apart faces of two parts may be.
bool isJoiningAskedFor(const input::Parameters& list);

/// What the list of an interface says, whose law is `law`; `depth` as for mesh::InterfaceFinder.
mortar::JoinOptions joinOptions(const input::Parameters& list, const laws::InterfaceLaw& law, const mesh::Depth& depth);

}  // namespace harmos::scene
