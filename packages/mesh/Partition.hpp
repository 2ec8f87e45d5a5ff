#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Nodes of the mesh: elements at them that are connected through faces with each other stay in one piece.
struct Together {
  std::vector<int> nodes;
  std::string remedy;  // what would let them be divided, for messages, after "or"; empty: nothing does
};

/// Cuts a part into `pieces` parts of about the same number of elements with few faces between them, by METIS.
///
/// The pieces are named "<name>.1", "<name>.2", ... in the order of their first elements, are each connected through
/// element faces, and are the same in every run. A part of several unconnected groups of elements is cut group by
/// group. One piece gives the part itself, whatever its groups. Throws base::Error(input) if there are more pieces than
/// elements, fewer than groups or less than one; base::Error when METIS fails. Not collective.
///
/// What is `together` makes pieces of different sizes. Throws base::Error(input) with its remedies if it leaves too few
/// of them.
/// Source: Karypis, Kumar (1998), doi:10.1137/S1064827595287997.
std::vector<Piece> cutPart(const Mesh& mesh, const Piece& part, int pieces, const std::vector<Together>& together = {});

}  // namespace harmos::mesh
