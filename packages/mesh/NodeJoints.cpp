#include <harmos/mesh/detail/NodeJoints.hpp>

#include <algorithm>

#include <harmos/mesh/detail/NodalWeights.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {

std::vector<InterfaceSurface> joinNodes(const CutMesh& parts, const std::string& name, const std::vector<int>& pieces1,
                                        const std::vector<int>& pieces2,
                                        const std::vector<std::pair<int, int>>& pairs) {
  std::vector<int> nodes1, nodes2;
  for (const auto& [node1, node2] : pairs) {
    nodes1.push_back(node1);
    nodes2.push_back(node2);
  }
  std::sort(nodes1.begin(), nodes1.end());
  std::sort(nodes2.begin(), nodes2.end());
  const NodalWeights weights1(parts.mesh, parts.elements, parts.map, pieces1, nodes1, parts.depth);
  const NodalWeights weights2(parts.mesh, parts.elements, parts.map, pieces2, nodes2, parts.depth);
  SurfaceBuilders builders(parts.mesh, parts.pieces, noCrease);
  for (const auto& [node1, node2] : pairs) {
    // Where a body is cut, its pieces are tied to each other: one of them is enough.
    const auto holder = [&](const std::vector<int>& pieces, int node) {
      return *std::find_if(pieces.begin(), pieces.end(), [&](int piece) { return parts.map.has(piece, node); });
    };
    NodalWeight mean = weights1.total(node1).scaled(0.5);
    mean += weights2.total(node2).scaled(0.5, -1.0);
    builders.addNode(holder(pieces1, node1), holder(pieces2, node2), node1, node2, mean);
  }
  return builders.build(name);
}

}  // namespace harmos::mesh
