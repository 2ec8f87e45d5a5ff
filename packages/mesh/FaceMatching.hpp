#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// Two faces whose nodes coincide: node i of the first face lies on nodes2[i].
struct FacePair {
  int face1 = -1;           // position in the list of faces of side 1
  int face2 = -1;           // position in the list of faces of side 2
  std::vector<int> nodes2;  // mesh node numbers of the second face, in the order of the nodes of the first
};

/// How far nodes of two sides may lie apart and still coincide, as a fraction of the shortest edge of the face [-].
constexpr double conformingTolerance = 1e-4;

/// Pairs every face of one side with the face of the other whose nodes coincide and whose normal is opposite.
///
/// With a unit vector `projection` the nodes need only coincide when seen along it. Sorted by face1; faces without a
/// partner do not appear, no face does twice. O(n log n).
std::vector<FacePair> matchFaces(const Mesh& mesh, const std::vector<Face>& side1, const std::vector<Face>& side2,
                                 const std::optional<base::Vector3>& projection = std::nullopt);

/// How far the nodes of one list are from the nearest node of another.
struct Separation {
  int node = -1;          // of the first list, that has the largest distance
  double largest = 0.0;   // [length]
  double smallest = 0.0;  // [length]
};

/// The distances from the nodes `from` to the nearest of `to` (mesh node numbers, neither list empty), seen along the
/// unit vector `projection` if there is one. `nodes`: coordinates of the mesh nodes [length].
Separation separation(const std::vector<base::Vector3>& nodes, const std::vector<int>& from, const std::vector<int>& to,
                      const std::optional<base::Vector3>& projection = std::nullopt);

/// The mesh node numbers of faces, ascending, each once.
std::vector<int> nodesOf(const std::vector<Face>& faces);

/// Pairs the nodes (mesh node numbers) of two sides that coincide, by ascending node of the first; each node of `side2`
/// at most once. They coincide within conformingTolerance of the shortest edge of the faces around the first.
std::vector<std::pair<int, int>> matchNodes(const Mesh& mesh, const std::vector<Face>& side1,
                                            const std::vector<Face>& side2);

/// Length [length] of the shortest edge of the faces around each of their nodes, by mesh node number.
std::map<int, double> localSizes(const Mesh& mesh, const std::vector<Face>& faces);

/// Length [length] of the shortest edge of the closed line through the corners.
double shortestEdge(const std::vector<base::Vector3>& corners);

}  // namespace harmos::mesh
