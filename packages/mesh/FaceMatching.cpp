#include <harmos/mesh/FaceMatching.hpp>

#include <algorithm>
#include <limits>
#include <set>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/PointSearch.hpp>

namespace harmos::mesh {
namespace {

base::Vector3 project(const base::Vector3& point, const std::optional<base::Vector3>& projection) {
  return projection ? point - dot(point, *projection) * *projection : point;
}

struct PlacedFace {
  std::vector<base::Vector3> nodes;  // projected
  double shortestEdge = 0.0;         // the same
  base::Vector3 centre{};
  base::Vector3 normal{};  // not projected, any length
};

std::vector<PlacedFace> place(int dimension, const std::vector<base::Vector3>& nodes, const std::vector<Face>& faces,
                              const std::optional<base::Vector3>& projection) {
  std::vector<PlacedFace> result;
  for (const Face& face : faces) {
    PlacedFace placed;
    std::vector<base::Vector3> places;
    for (const int node : face.nodes) {
      places.push_back(nodes[node]);
      placed.nodes.push_back(project(places.back(), projection));
      placed.centre = placed.centre + (1.0 / static_cast<double>(face.nodes.size())) * placed.nodes.back();
    }
    const int corners = cornersOfFace(dimension, places.size());
    placed.shortestEdge = shortestEdge({placed.nodes.begin(), placed.nodes.begin() + corners});
    for (const NodalWeight& part : integrateFace(dimension, places, 1.0).weight) {
      placed.normal = placed.normal + part.flux;
    }
    if (projection) placed.normal = dot(placed.normal, *projection) * *projection;
    result.push_back(std::move(placed));
  }
  return result;
}

/// The nodes of `face2` in the order of the nodes of `a` on which they lie; empty if they do not coincide.
std::vector<int> partners(const PlacedFace& a, const PlacedFace& b, const Face& face2, double tolerance) {
  std::vector<int> result;
  if (a.nodes.size() != b.nodes.size()) return result;
  for (const base::Vector3& at : a.nodes) {
    for (std::size_t j = 0; j < b.nodes.size(); ++j) {
      if (distance(at, b.nodes[j]) <= tolerance) result.push_back(face2.nodes[j]);
    }
  }
  if (result.size() != a.nodes.size()) result.clear();
  return result;
}

}  // namespace

std::vector<FacePair> matchFaces(const Mesh& mesh, const std::vector<Face>& side1, const std::vector<Face>& side2,
                                 const std::optional<base::Vector3>& projection) {
  const auto placed1 = place(mesh.dimension, mesh.nodes, side1, projection);
  const auto placed2 = place(mesh.dimension, mesh.nodes, side2, projection);
  std::vector<base::Vector3> centres;
  for (const PlacedFace& face : placed2) centres.push_back(face.centre);
  const PointSearch search(std::move(centres));
  std::vector<bool> taken(side2.size(), false);
  std::vector<FacePair> pairs;
  for (std::size_t i = 0; i < side1.size(); ++i) {
    const double tolerance = conformingTolerance * placed1[i].shortestEdge;
    for (const int candidate : search.within(placed1[i].centre, tolerance)) {
      const auto j = static_cast<std::size_t>(candidate);
      if (taken[j] || !(dot(placed1[i].normal, placed2[j].normal) < 0.0)) continue;
      auto nodes2 = partners(placed1[i], placed2[j], side2[j], tolerance);
      if (nodes2.empty()) continue;
      taken[j] = true;
      pairs.push_back({static_cast<int>(i), candidate, std::move(nodes2)});
      break;
    }
  }
  return pairs;
}

Separation separation(const std::vector<base::Vector3>& nodes, const std::vector<int>& from, const std::vector<int>& to,
                      const std::optional<base::Vector3>& projection) {
  std::vector<base::Vector3> points;
  for (const int node : to) points.push_back(project(nodes[node], projection));
  const PointSearch search(std::move(points));
  Separation result{-1, -1.0, std::numeric_limits<double>::infinity()};
  for (const int node : from) {
    const double away = search.nearest(project(nodes[node], projection)).distance;
    if (away > result.largest) {
      result.largest = away;
      result.node = node;
    }
    result.smallest = std::min(result.smallest, away);
  }
  return result;
}

std::vector<int> nodesOf(const std::vector<Face>& faces) {
  std::vector<int> nodes;
  for (const Face& face : faces) nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

double shortestEdge(const std::vector<base::Vector3>& corners) {
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    length = std::min(length, distance(corners[i], corners[(i + 1) % corners.size()]));
  }
  return length;
}

std::map<int, double> localSizes(const Mesh& mesh, const std::vector<Face>& faces) {
  std::map<int, double> sizes;
  for (const Face& face : faces) {
    const auto last = face.nodes.begin() + cornersOfFace(mesh.dimension, face.nodes.size());
    const double size = shortestEdge(pointsOf(mesh, {face.nodes.begin(), last}));
    for (const int node : face.nodes) {
      const auto [entry, isNew] = sizes.emplace(node, size);
      entry->second = std::min(entry->second, size);
    }
  }
  return sizes;
}

std::vector<std::pair<int, int>> matchNodes(const Mesh& mesh, const std::vector<Face>& side1,
                                            const std::vector<Face>& side2) {
  const std::vector<int> nodes2 = nodesOf(side2);
  const PointSearch search(pointsOf(mesh, nodes2));
  std::set<int> taken;
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [node1, size] : localSizes(mesh, side1)) {
    const auto nearest = search.nearest(mesh.nodes[node1]);
    if (nearest.index < 0 || nearest.distance > conformingTolerance * size) continue;
    const int node2 = nodes2[nearest.index];
    if (taken.insert(node2).second) pairs.emplace_back(node1, node2);
  }
  return pairs;
}

}  // namespace harmos::mesh
