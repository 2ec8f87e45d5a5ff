#include <harmos/mesh/detail/InnerFaces.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace harmos::mesh {
namespace {

std::vector<int> sorted(std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

std::vector<Face> innerFaces(const Mesh& mesh, const Elements& elements, const PieceMap& map,
                             const std::vector<Face>& faces) {
  std::vector<bool> isMarked(mesh.nodes.size(), false);
  std::map<std::vector<int>, std::vector<int>> sharing;  // elements, by the nodes of a face
  std::set<std::string> parts;
  for (const Face& face : faces) {
    for (const int node : face.nodes) isMarked[node] = true;
    sharing[sorted(face.nodes)];
    parts.insert(map.part(map.of(face.element)));
  }
  std::vector<int> candidates;  // not all of the mesh: hundreds of parts may have faces that are asked about
  for (const std::string& part : parts) {
    const std::vector<int> more = map.elements(map.named(part, part));
    candidates.insert(candidates.end(), more.begin(), more.end());
  }
  for (const int element : candidates) {
    const ElementType type = elements.type(element);
    const int* nodes = elements.nodes(element);
    if (std::count_if(nodes, nodes + nodesPerElement(type), [&](int node) { return isMarked[node]; }) <
        mesh.dimension) {
      continue;
    }
    for (int side = 0; side < sidesPerElement(type); ++side) {
      const std::vector<int>& local = sideNodes(type, side);
      if (!std::all_of(local.begin(), local.end(), [&](int i) { return isMarked[nodes[i]]; })) continue;
      const auto found = sharing.find(sorted(elements.side(element, side)));
      if (found != sharing.end()) found->second.push_back(element);
    }
  }
  std::vector<Face> inner;
  for (const Face& face : faces) {
    const std::string& part = map.part(map.of(face.element));
    const std::vector<int>& around = sharing.at(sorted(face.nodes));
    if (std::any_of(around.begin(), around.end(),
                    [&](int element) { return element != face.element && map.part(map.of(element)) == part; })) {
      inner.push_back(face);
    }
  }
  return inner;
}

}  // namespace harmos::mesh
