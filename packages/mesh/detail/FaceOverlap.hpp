#pragma once

#include <utility>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// The pairs (index into `side1`, index into `side2`) of faces that lie on each other: their normals are opposite, they
/// overlap by more than a hundredth of the smaller one when seen along the first one's normal, and either lie in one
/// plane, within a thousandth of their shortest edge, or touch in a node and hardly deviate, as the facets of two
/// meshes of one curved surface do. `nodes` are those of the mesh; in 2-D faces have two nodes. O((n + pairs) log n).
std::vector<std::pair<int, int>> overlappingFaces(const std::vector<base::Vector3>& nodes,
                                                  const std::vector<Face>& side1, const std::vector<Face>& side2);

}  // namespace harmos::mesh
