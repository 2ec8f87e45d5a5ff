#pragma once

#include <cstddef>
#include <vector>

#include <metis.h>

#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {

/// Elements that share a face, in compressed rows; a vertex may stand for several.
struct FaceGraph {
  std::vector<idx_t> first, neighbour, weight;  // weight: elements of a vertex
  /// Vertices.
  int size() const { return static_cast<int>(first.size()) - 1; }
};

/// Elements of a mesh of so many nodes, one vertex each. Throws base::Error when METIS has not enough memory.
FaceGraph faceGraph(const Elements& mesh, const std::vector<int>& elements, std::size_t nodeCount);

/// The graph with one of `count` vertices for all elements of a kind, `vertexOf` each element.
FaceGraph contracted(const FaceGraph& graph, const std::vector<int>& vertexOf, int count);

/// Numbers the connected groups of vertices of equal colour, by their lowest vertex; `count`: how many there are.
std::vector<idx_t> connectedGroups(const FaceGraph& graph, const std::vector<idx_t>& colour, int& count);

/// The vertices of one group; `members` becomes their numbers in the whole graph.
FaceGraph partOf(const FaceGraph& graph, const std::vector<idx_t>& group, idx_t which, std::vector<int>& members);

}  // namespace harmos::mesh
