#pragma once

#include <string>
#include <vector>

#include <harmos/latin/Iterate.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::scene {

/// A part of the scene as one, whatever it was cut into; of a part that an interface divides one side of it.
struct PartPieces {
  std::string name;         ///< in the list Parts; with the side where an interface divides the part
  mesh::Piece piece;        ///< all its elements
  std::vector<int> bodies;  ///< that it was cut into
};

/// The parts that pieces belong to, in their order.
std::vector<PartPieces> partPieces(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces);

/// Displacement [length] of a node of an owned body of the part that strains the part as the whole one does: with most
/// digits of one body, but all bodies must count from the same place.
inline base::Vector3 strainingDisplacement(const latin::Iterate& state, const PartPieces& part, int body, int node,
                                           int column) {
  return part.bodies.size() == 1 ? state.relativeDisplacement(body, node, column)
                                 : state.displacement(body, node, column);
}

}  // namespace harmos::scene
