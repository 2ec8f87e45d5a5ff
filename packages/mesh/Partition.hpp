#pragma once

#include <vector>

#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Cuts a part into `pieces` parts of about the same number of elements with few faces between them, by METIS.
///
/// The pieces are named "<name>.1", "<name>.2", ... in the order of their first elements, are each connected through
/// element faces, and are the same in every run. A part of several unconnected groups of elements is cut group by
/// group. One piece gives the part itself, whatever its groups. Throws base::Error(input) if there are more pieces than
/// elements, fewer than groups or less than one; base::Error when METIS fails. Not collective.
///
/// `together`: lists of nodes of the mesh. Elements at the nodes of one list that are connected through faces with each
/// other stay in one piece; pieces of different sizes are the price. Throws base::Error(input) if that leaves too few
/// pieces.
/// Source: Karypis, Kumar (1998), doi:10.1137/S1064827595287997.
std::vector<Piece> cutPart(const Mesh& mesh, const Piece& part, int pieces,
                           const std::vector<std::vector<int>>& together = {});

}  // namespace harmos::mesh
