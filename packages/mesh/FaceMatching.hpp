#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// Two faces whose nodes coincide: node i of the first face lies on nodes2[i].
struct FacePair {
  int face1 = -1;  // index into the lists of faces
  int face2 = -1;
  std::vector<int> nodes2;  // mesh node numbers
};

/// How far nodes of two sides may lie apart and still coincide, as a fraction of the shortest edge of the face.
constexpr double conformingTolerance = 1e-4;

/// Pairs every face of one side with the face of the other whose nodes coincide and whose normal is opposite.
///
/// With a unit vector `projection` the nodes need only coincide when seen along it. Sorted by face1; faces without a
/// partner do not appear. O(n log n).
std::vector<FacePair> matchFaces(const std::vector<base::Vector3>& nodes, const std::vector<Face>& side1,
                                 const std::vector<Face>& side2,
                                 const std::optional<base::Vector3>& projection = std::nullopt);

/// The largest distance from a node of one list to the nearest of the other, seen along `projection` if there is one.
struct Separation {
  int node = -1;  // of the first list, that has the largest distance
  double largest = 0.0;
  double smallest = 0.0;
};
Separation separation(const std::vector<base::Vector3>& nodes, const std::vector<int>& from, const std::vector<int>& to,
                      const std::optional<base::Vector3>& projection = std::nullopt);

/// The mesh node numbers of faces, ascending, each once.
std::vector<int> nodesOf(const std::vector<Face>& faces);

/// Pairs the nodes of two sides that coincide, by ascending node of the first; each node of `side2` at most once.
std::vector<std::pair<int, int>> matchNodes(const Mesh& mesh, const std::vector<Face>& side1,
                                            const std::vector<Face>& side2);

/// Length of the shortest edge of the faces around each of their nodes.
std::map<int, double> localSizes(const Mesh& mesh, const std::vector<Face>& faces);

/// Length of the shortest edge.
double shortestEdge(const std::vector<base::Vector3>& corners);

}  // namespace harmos::mesh
