#include <harmos/mesh/detail/NodeJoints.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <harmos/mesh/detail/NodalWeights.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {

std::vector<int> sharedNodes(const CutMesh& parts, const std::vector<int>& pieces1, const std::vector<int>& pieces2) {
  const auto count = [&](const std::vector<int>& pieces) {
    return std::accumulate(pieces.begin(), pieces.end(), std::size_t{0},
                           [&](std::size_t sum, int piece) { return sum + parts.pieces[piece].nodes.size(); });
  };
  // Those of the smaller part are looked up, for it may be one of hundreds on the other.
  const bool isSmaller = count(pieces1) < count(pieces2);
  const std::vector<int>&smaller = isSmaller ? pieces1 : pieces2, &larger = isSmaller ? pieces2 : pieces1;
  std::vector<int> shared;
  for (const int piece : smaller) {
    for (const int node : parts.pieces[piece].nodes) {
      if (std::any_of(larger.begin(), larger.end(), [&](int other) { return parts.map.has(other, node); })) {
        shared.push_back(node);
      }
    }
  }
  return shared;
}

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
