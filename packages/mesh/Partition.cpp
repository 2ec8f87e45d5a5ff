#include <harmos/mesh/Partition.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <string>

#include <metis.h>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {
namespace {

/// Elements that share a face, in compressed rows; a vertex may stand for several.
struct FaceGraph {
  std::vector<idx_t> first, neighbour, weight;  // weight: elements of a vertex
  int size() const { return static_cast<int>(first.size()) - 1; }
};

[[noreturn]] void refuse(const Piece& part, int pieces, const std::string& what) {
  throw base::Error("Part \"" + part.name + "\": Pieces = " + std::to_string(pieces) + ", but " + what,
                    base::ExitCode::input);
}

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

/// The vertex of each element where those at the nodes of one list that are connected with each other share one.
std::vector<int> vertices(const Elements& mesh, const std::vector<int>& elements, const FaceGraph& graph,
                          const std::vector<Together>& together, int& count) {
  std::vector<int> root(elements.size());
  std::iota(root.begin(), root.end(), 0);
  const auto rootOf = [&](int at) {
    while (root[at] != at) at = root[at] = root[root[at]];
    return at;
  };
  for (const Together& kept : together) {
    std::vector<int> nodes = kept.nodes;
    std::sort(nodes.begin(), nodes.end());
    std::vector<bool> touches(elements.size(), false);
    for (std::size_t at = 0; at < elements.size(); ++at) {
      const int* own = mesh.nodes(elements[at]);
      touches[at] = std::any_of(own, own + nodesPerElement(mesh.type(elements[at])),
                                [&](int node) { return std::binary_search(nodes.begin(), nodes.end(), node); });
    }
    for (std::size_t at = 0; at < elements.size(); ++at) {
      for (idx_t k = graph.first[at]; k < graph.first[at + 1] && touches[at]; ++k) {
        if (!touches[graph.neighbour[k]]) continue;
        const int one = rootOf(static_cast<int>(at)), other = rootOf(graph.neighbour[k]);
        root[std::max(one, other)] = std::min(one, other);
      }
    }
  }
  count = 0;
  std::vector<int> result(elements.size());
  for (std::size_t at = 0; at < elements.size(); ++at) {
    const int first = rootOf(static_cast<int>(at));
    result[at] = first == static_cast<int>(at) ? count++ : result[first];
  }
  return result;
}

/// The graph with one vertex for all elements of a kind.
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

/// Numbers the connected groups of vertices of equal colour, by their lowest vertex.
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

/// Splits a connected group of at least two vertices in two: of a spanning tree, the branch nearest to half of it
/// becomes the group `colour`.
void splitGroup(const FaceGraph& graph, std::vector<idx_t>& group, idx_t which, idx_t colour) {
  std::vector<int> order, parent(group.size(), -1), branch(group.size(), 1);
  order.push_back(static_cast<int>(std::find(group.begin(), group.end(), which) - group.begin()));
  parent[order[0]] = order[0];
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto at = static_cast<std::size_t>(order[i]);
    for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
      const auto next = static_cast<std::size_t>(graph.neighbour[k]);
      if (group[next] != which || parent[next] >= 0) continue;
      parent[next] = order[i];
      order.push_back(static_cast<int>(next));
    }
  }
  const int half = static_cast<int>(order.size()) / 2;
  int best = order[1];
  for (std::size_t i = order.size() - 1; i > 0; --i) {
    const auto at = static_cast<std::size_t>(order[i]);
    branch[parent[at]] += branch[at];
    if (std::abs(branch[at] - half) < std::abs(branch[best] - half)) best = order[i];
  }
  group[best] = colour;
  for (const int vertex : order) {
    const auto at = static_cast<std::size_t>(vertex);
    if (group[parent[at]] == colour && parent[at] != vertex) group[at] = colour;
  }
}

/// Makes the connected groups as many as the pieces asked for, which METIS misses on small graphs: joins the smallest
/// group to its smallest neighbour, or splits the largest.
void repairGroups(const FaceGraph& graph, std::vector<idx_t>& group, int count, int pieces) {
  while (count != pieces) {
    std::vector<int> size(count, 0);
    for (const idx_t of : group) ++size[of];
    const auto extreme = std::minmax_element(size.begin(), size.end());
    if (count < pieces) {
      splitGroup(graph, group, static_cast<idx_t>(extreme.second - size.begin()), count);
      ++count;
      continue;
    }
    const auto smallest = static_cast<idx_t>(extreme.first - size.begin());
    idx_t target = -1;
    for (std::size_t at = 0; at < group.size(); ++at) {
      if (group[at] != smallest) continue;
      for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
        const idx_t other = group[graph.neighbour[k]];
        if (other == smallest) continue;
        if (target < 0 || size[other] < size[target]) target = other;
      }
    }
    --count;
    for (idx_t& of : group) {
      if (of == smallest) of = target;
      if (of == count) of = smallest;
    }
  }
}

/// Cuts a connected graph into connected pieces; the piece of every vertex. Of METIS' two methods takes the one with
/// fewer cut faces among those in balance, since either may be far off on small graphs.
std::vector<idx_t> cutConnected(FaceGraph graph, int pieces) {
  std::vector<idx_t> best(graph.size(), 0);
  if (pieces == 1) return best;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;  // the same pieces in every run
  idx_t vertices = graph.size();
  idx_t weights = 1;
  idx_t parts = pieces;
  idx_t unused = 0;
  const auto elements = std::accumulate(graph.weight.begin(), graph.weight.end(), std::size_t{0});
  const std::size_t inBalance =
      (11 * elements + 10 * static_cast<std::size_t>(pieces) - 1) / (10 * static_cast<std::size_t>(pieces));
  std::pair<std::size_t, std::size_t> bestCost;
  for (const auto method : {METIS_PartGraphKway, METIS_PartGraphRecursive}) {
    options[METIS_OPTION_CONTIG] = method == METIS_PartGraphKway ? 1 : 0;
    std::vector<idx_t> piece(best.size());
    if (method(&vertices, &weights, graph.first.data(), graph.neighbour.data(), graph.weight.data(), nullptr, nullptr,
               &parts, nullptr, nullptr, options, &unused, piece.data()) != METIS_OK) {
      throw base::Error("METIS cannot cut the graph of elements; there may not be enough memory.");
    }
    int groups = 0;
    piece = connectedGroups(graph, piece, groups);
    repairGroups(graph, piece, groups, pieces);
    std::vector<std::size_t> size(pieces, 0);
    std::size_t cutFaces = 0;
    for (std::size_t at = 0; at < piece.size(); ++at) {
      size[piece[at]] += static_cast<std::size_t>(graph.weight[at]);
      for (idx_t k = graph.first[at]; k < graph.first[at + 1]; ++k) {
        if (piece[graph.neighbour[k]] != piece[at]) ++cutFaces;
      }
    }
    const std::pair cost(std::max(inBalance, *std::max_element(size.begin(), size.end())), cutFaces);
    if (method == METIS_PartGraphKway || cost < bestCost) {
      best = std::move(piece);
      bestCost = cost;
    }
  }
  return best;
}

std::string remediesOf(const std::vector<Together>& together) {
  std::set<std::string> known;
  std::string more;
  for (const Together& kept : together) {
    if (!kept.remedy.empty() && known.insert(kept.remedy).second) more += ", or " + kept.remedy;
  }
  return (more.empty() ? "give fewer pieces, or mesh the part finer"
                       : "give fewer pieces, mesh the part finer" + more) +
         ".";
}

/// How many pieces each body gets: one, and the others where the pieces are largest.
std::vector<int> shares(const std::vector<int>& sizes, int pieces) {
  std::vector<int> result(sizes.size(), 1);
  const auto pieceSize = [&](std::size_t body) { return static_cast<double>(sizes[body]) / result[body]; };
  for (int given = static_cast<int>(sizes.size()); given < pieces; ++given) {
    std::size_t largest = 0;
    for (std::size_t body = 1; body < sizes.size(); ++body) {
      if (pieceSize(body) > pieceSize(largest)) largest = body;
    }
    ++result[largest];
  }
  return result;
}

}  // namespace

std::vector<Piece> cutPart(const Mesh& mesh, const Piece& part, int pieces, const std::vector<Together>& together) {
  if (pieces == 1) return {part};
  if (pieces < 1 || static_cast<std::size_t>(pieces) > part.elements.size()) {
    refuse(part, pieces,
           "the part has " + std::to_string(part.elements.size()) + " elements; give a number from 1 to that.");
  }
  const Elements elements(mesh);
  const FaceGraph whole = faceGraph(elements, part.elements, mesh.nodes.size());
  int bodies = 0;
  const auto bodyOf = connectedGroups(whole, std::vector<idx_t>(part.elements.size(), 0), bodies);
  if (pieces < bodies) {
    refuse(part, pieces,
           "its elements form " + std::to_string(bodies) +
               " bodies that no face connects; give 1 or at least that many pieces, or make a part of "
               "each body.");
  }
  std::vector<std::vector<int>> lists(bodies);
  for (std::size_t i = 0; i < part.elements.size(); ++i) {
    lists[bodyOf[i]].push_back(part.elements[i]);
  }
  std::vector<int> sizes;
  for (const auto& list : lists) sizes.push_back(static_cast<int>(list.size()));
  const auto share = shares(sizes, pieces);

  std::vector<std::vector<int>> pieceElements;
  for (std::size_t body = 0; body < lists.size(); ++body) {
    const FaceGraph graph = bodies == 1 ? whole : faceGraph(elements, lists[body], mesh.nodes.size());
    int count = 0;
    const std::vector<int> vertexOf = vertices(elements, lists[body], graph, together, count);
    if (share[body] > count) {
      refuse(part, pieces,
             "its elements at faces of interfaces whose meshes do not match stay together, which leaves " +
                 std::to_string(count) + " to divide" + (bodies == 1 ? "" : " in one of its bodies") + "; " +
                 remediesOf(together));
    }
    const bool isAsItIs = count == graph.size();
    const auto group = cutConnected(isAsItIs ? graph : contracted(graph, vertexOf, count), share[body]);
    const std::size_t before = pieceElements.size();
    pieceElements.resize(before + static_cast<std::size_t>(share[body]));
    for (std::size_t i = 0; i < vertexOf.size(); ++i) {
      pieceElements[before + static_cast<std::size_t>(group[vertexOf[i]])].push_back(lists[body][i]);
    }
  }
  std::sort(pieceElements.begin(), pieceElements.end());
  std::vector<Piece> result;
  for (auto& list : pieceElements) {
    result.push_back(makePiece(mesh, part.name + "." + std::to_string(result.size() + 1),
                               part.part.empty() ? part.name : part.part, std::move(list)));
  }
  return result;
}

}  // namespace harmos::mesh
