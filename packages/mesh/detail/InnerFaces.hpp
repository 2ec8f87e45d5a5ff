#pragma once

#include <vector>

#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/PieceMap.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// Those of `faces` that lie inside of a part: another element of the same part has a side with the same nodes. In
/// their order. A face between parts that share nodes lies on the surface of both. O(elements).
std::vector<Face> innerFaces(const Mesh& mesh, const Elements& elements, const PieceMap& map,
                             const std::vector<Face>& faces);

}  // namespace harmos::mesh
