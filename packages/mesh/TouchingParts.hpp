#pragma once

#include <string>
#include <utility>
#include <vector>

#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Names of two parts.
using PartPair = std::pair<std::string, std::string>;

/// The pairs of a part of `parts1` and another of `parts2` that have faces on each other, matching or not, as
/// InterfaceFinder::betweenParts() sees them; common edges and nodes alone do not count. Each pair once, though both
/// parts may be in both lists: the first of it is the one that comes first in `parts1`. In the order of `parts1`, then
/// of `parts2`.
///
/// `pieces`: of all parts, those that were cut as several. Near linear in the number of parts and faces as long as the
/// boxes around the parts meet few others. Not collective: the whole mesh is on the rank that asks.
std::vector<PartPair> touchingParts(const Mesh& mesh, const std::vector<Piece>& pieces,
                                    const std::vector<std::string>& parts1, const std::vector<std::string>& parts2);

}  // namespace harmos::mesh
