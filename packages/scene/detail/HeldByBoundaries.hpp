#pragma once

#include <vector>

#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mortar/HeldDirections.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// The directions along which boundaries of a scene give the displacements of nodes at all load steps: symmetry,
/// prescribed displacement. `components`: of a displacement. Boundaries that are faulty are passed over; they are
/// reported where they are made.
mortar::HeldDirections heldByBoundaries(const Scene& scene, int components, const std::vector<mesh::Piece>& pieces,
                                        const mesh::InterfaceFinder& finder);

}  // namespace harmos::scene
