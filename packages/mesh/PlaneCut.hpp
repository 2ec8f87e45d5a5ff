#pragma once

#include <utility>
#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// A plane in space, or a line in the plane.
struct Plane {
  base::Vector3 point{};   ///< on it [length]
  base::Vector3 normal{};  ///< of any length, not 0
};

/// Divides the elements of a part along the layer of their faces that is nearest to a plane, over its whole section:
/// those behind it, and those beyond it in the direction of the normal; mesh element numbers, ascending. No node moves.
///
/// An element is on the side on which its centre lies. Throws base::Error(input), without a place, when all are on one
/// side, or when the faces between the sides do not lie in one plane parallel to the given one within a thousandth of
/// their extent: the elements have no layer of faces there.
std::pair<std::vector<int>, std::vector<int>> divideAlong(const Mesh& mesh, const Piece& part, const Plane& plane);

}  // namespace harmos::mesh
