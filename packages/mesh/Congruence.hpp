#pragma once

#include <optional>
#include <vector>

#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// A rigid motion or mirror image x -> Q x + c that carries one part onto another, node by node and element by element.
/// c carries the centroid of the nodes of the first onto that of the second and is not kept.
struct Congruence {
  std::vector<int> node;   // node[a]: the second part's local node on which local node a of the first falls
  base::Frame rotation{};  // rows of Q, orthogonal, determinant +1 or -1; in 2-D the z axis stays
};

/// Finds a congruence of two parts, a translation if there is one; none if they are not equal. Nodes coincide within
/// 1e-9 of the parts' size (the largest distance of a node from the centroid of the nodes), elements have the same type
/// and sides. Materials are not looked at: Q turns them, too.
///
/// `kindsOfFirst`, `kindsOfSecond`: of the local nodes of each part, one number per node; only motions that carry every
/// node onto one of its kind are found then. Empty: nodes have none.
///
/// Tries the motions that carry two nodes of which few others have the same distances from the centroid (in 2-D one
/// node) onto nodes with these distances, so that every congruence is found whatever the symmetries of the part.
std::optional<Congruence> findCongruence(const Mesh& mesh, const Piece& first, const Piece& second,
                                         const std::vector<int>& kindsOfFirst = {},
                                         const std::vector<int>& kindsOfSecond = {});

}  // namespace harmos::mesh
