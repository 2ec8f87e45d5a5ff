#pragma once

#include <vector>

#include <harmos/input/Parameters.hpp>
#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::scene {

/// What a boundary may say of nodes on the axis of axisymmetry that none of its surfaces has, because the faces around
/// them have no area: that they do not leave the axis, nor turn around it, as is so without it. Tractions and springs
/// have no force there. Throws base::Error (input) where it holds them along the axis, or moves them.
void demandNothingAlongAxis(const input::Parameters& boundary, const laws::InterfaceLaw& law, int steps,
                            const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                            const mesh::InterfaceFinder& finder, const std::vector<mesh::InterfaceSurface>& surfaces);

}  // namespace harmos::scene
