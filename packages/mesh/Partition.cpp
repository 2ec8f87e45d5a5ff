#include <harmos/mesh/Partition.hpp>

#include <algorithm>
#include <set>
#include <string>

#include <harmos/base/DisjointSets.hpp>
#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/detail/GraphCut.hpp>

namespace harmos::mesh {
namespace {

[[noreturn]] void refuse(const Piece& part, int pieces, const std::string& what) {
  throw base::Error("Part \"" + part.name + "\": Pieces = " + std::to_string(pieces) + ", but " + what,
                    base::ExitCode::input);
}

/// The vertex of each element where those at the nodes of one list that are connected with each other share one.
std::vector<int> vertices(const Elements& mesh, const std::vector<int>& elements, const FaceGraph& graph,
                          const std::vector<Together>& together, int& count) {
  base::DisjointSets sets(elements.size());
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
        const auto [least, other] =
            std::minmax({sets.root(static_cast<int>(at)), sets.root(static_cast<int>(graph.neighbour[k]))});
        sets.join(other, least);
      }
    }
  }
  count = 0;
  std::vector<int> result(elements.size());
  for (std::size_t at = 0; at < elements.size(); ++at) {
    const int first = sets.root(static_cast<int>(at));
    result[at] = first == static_cast<int>(at) ? count++ : result[first];
  }
  return result;
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
    const auto group = cutGraph(isAsItIs ? graph : contracted(graph, vertexOf, count), share[body]);
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
