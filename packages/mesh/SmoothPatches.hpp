#pragma once

#include <utility>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// A crease angle [degrees] that no surface has.
inline constexpr double noCrease = 180.0;

/// The mesh nodes of side 1 and side 2 that face each other; the second is -1 on an outer boundary.
using NodePair = std::pair<int, int>;

/// A face of an interface, or of one of its sides.
struct OrientedFace {
  std::vector<NodePair> pairs;  // its corners
  base::Vector3 normal{};       // out of side 1, any length
};

/// Which smooth patch of the faces around a pair a corner of a face belongs to: patch[face][corner], counted from 0 at
/// every pair by the first face of the list.
///
/// Two faces around a pair are in one patch if their normals differ by at most `creaseAngle` [degrees], or if a chain
/// of such faces around the pair leads from one to the other. So a coarse cylinder, the tip of a cone and faces of both
/// sides that are divided differently are one patch; the faces of a box at its edges are several. Whether faces share
/// an edge does not matter: patches of one normal could not be told apart by any law. O(faces), times their number
/// around a pair.
std::vector<std::vector<int>> smoothPatches(const std::vector<OrientedFace>& faces, double creaseAngle);

}  // namespace harmos::mesh
