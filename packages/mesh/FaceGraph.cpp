#include <harmos/mesh/detail/FaceGraph.hpp>

#include <algorithm>
#include <memory>

#include <harmos/base/Error.hpp>

namespace harmos::mesh {

FaceGraph faceGraph(const Elements& mesh, const std::vector<int>& elements, std::size_t nodeCount) {
  std::vector<idx_t> begin = {0}, nodes;
  std::size_t fewest = 4;  // nodes of a face
  for (const int element : elements) {
    const ElementType type = linearType(mesh.type(element));  // elements that share corners share the nodes between
    const int* own = mesh.nodes(element);
    nodes.insert(nodes.end(), own, own + nodesPerElement(type));
    begin.push_back(static_cast<idx_t>(nodes.size()));
    for (int side = 0; side < sidesPerElement(type); ++side) fewest = std::min(fewest, sideNodes(type, side).size());
  }
  auto elementCount = static_cast<idx_t>(elements.size());
  auto highest = static_cast<idx_t>(nodeCount);
  auto common = static_cast<idx_t>(fewest);
  idx_t numbering = 0;
  idx_t* rows = nullptr;
  idx_t* columns = nullptr;
  if (METIS_MeshToDual(&elementCount, &highest, begin.data(), nodes.data(), &common, &numbering, &rows, &columns) !=
      METIS_OK) {
    throw base::Error("METIS cannot build the graph of elements; there may not be enough memory.");
  }
  const std::unique_ptr<idx_t, int (*)(void*)> rowOwner(rows, [](void* p) { return METIS_Free(p); });
  const std::unique_ptr<idx_t, int (*)(void*)> columnOwner(columns, [](void* p) { return METIS_Free(p); });
  return {
      {rows, rows + elementCount + 1}, {columns, columns + rows[elementCount]}, std::vector<idx_t>(elements.size(), 1)};
}

FaceGraph contracted(const FaceGraph& graph, const std::vector<int>& vertexOf, int count) {
  FaceGraph result;
  result.weight.assign(count, 0);
  std::vector<std::vector<idx_t>> neighbours(count);
  for (std::size_t at = 0; at < vertexOf.size(); ++at) {
    ++result.weight[vertexOf[at]];
    for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
      const int other = vertexOf[graph.neighbour[k]];
      if (other != vertexOf[at]) neighbours[vertexOf[at]].push_back(other);
    }
  }
  result.first.push_back(0);
  for (std::vector<idx_t>& row : neighbours) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    result.neighbour.insert(result.neighbour.end(), row.begin(), row.end());
    result.first.push_back(static_cast<idx_t>(result.neighbour.size()));
  }
  return result;
}

std::vector<idx_t> connectedGroups(const FaceGraph& graph, const std::vector<idx_t>& colour, int& count) {
  std::vector<idx_t> group(graph.size(), -1);
  count = 0;
  std::vector<int> queue;
  for (int start = 0; start < graph.size(); ++start) {
    if (group[start] >= 0) continue;
    queue.assign(1, start);
    group[start] = count;
    while (!queue.empty()) {
      const auto at = static_cast<std::size_t>(queue.back());
      queue.pop_back();
      for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
        const auto next = static_cast<std::size_t>(graph.neighbour[k]);
        if (group[next] >= 0 || colour[next] != colour[at]) continue;
        group[next] = count;
        queue.push_back(static_cast<int>(next));
      }
    }
    ++count;
  }
  return group;
}

FaceGraph partOf(const FaceGraph& graph, const std::vector<idx_t>& group, idx_t which, std::vector<int>& members) {
  members.clear();
  std::vector<idx_t> number(group.size(), -1);
  for (std::size_t at = 0; at < group.size(); ++at) {
    if (group[at] != which) continue;
    number[at] = static_cast<idx_t>(members.size());
    members.push_back(static_cast<int>(at));
  }
  FaceGraph part;
  part.first.push_back(0);
  for (const int at : members) {
    for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
      if (number[graph.neighbour[k]] >= 0) part.neighbour.push_back(number[graph.neighbour[k]]);
    }
    part.first.push_back(static_cast<idx_t>(part.neighbour.size()));
    part.weight.push_back(graph.weight[at]);
  }
  return part;
}

}  // namespace harmos::mesh
