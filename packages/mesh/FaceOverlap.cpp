#include <harmos/mesh/detail/FaceOverlap.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

// Without the older rescaling of coordinates to integers, of which g++ 12 believes that it reads what is not set.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace harmos::mesh {
namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box3 = geometry::model::box<Corner>;
using Flat = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<Flat>;

constexpr double leastOverlap = 1e-2;  // of the smaller face
constexpr double touching = 1e-3;      // of the shortest edge
// Two meshes of one curved surface have facets that touch in nodes, lie within so much of the longer edge of each other
// and are turned by less than the angle of this cosine; a gap that opens from there is wider.
constexpr double sagitta = 0.05;
constexpr double facing = 0.98;
constexpr double close = 0.1;  // of the shortest edge: corners that would coincide without a gap

/// What is asked of a face again and again; curved ones count as those with straight edges.
struct Facet {
  Facet(const Mesh& mesh, const Face& face) {
    const int count = cornersOfFace(mesh.dimension, face.nodes.size());
    for (int i = 0; i < count; ++i) corners.push_back(mesh.nodes[face.nodes[i]]);
    for (const base::Vector3& x : corners) centre = centre + (1.0 / static_cast<double>(corners.size())) * x;
    if (corners.size() == 2) {
      const base::Vector3 along = corners[1] - corners[0];
      normal = {along[1], -along[0], 0.0};
    } else {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        normal = normal + cross(corners[i] - centre, corners[(i + 1) % corners.size()] - centre);
      }
    }
    normal = (1.0 / std::max(norm(normal), 1e-300)) * normal;
    edge = shortestEdge(corners);
  }

  Box3 box() const {
    base::Vector3 lower = corners[0], upper = corners[0];
    for (const base::Vector3& x : corners) {
      for (int c = 0; c < 3; ++c) {
        lower[c] = std::min(lower[c], x[c] - touching * edge);
        upper[c] = std::max(upper[c], x[c] + touching * edge);
      }
    }
    return {Corner(lower[0], lower[1], lower[2]), Corner(upper[0], upper[1], upper[2])};
  }

  std::vector<base::Vector3> corners;
  base::Vector3 centre{}, normal{};
  double edge = 0.0;
};

/// Two unit vectors across a unit vector.
std::pair<base::Vector3, base::Vector3> across(const base::Vector3& normal) {
  const int least = static_cast<int>(
      std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      normal.begin());
  base::Vector3 axis{};
  axis[least] = 1.0;
  const base::Vector3 first = cross(normal, axis);
  const base::Vector3 unit = (1.0 / norm(first)) * first;
  return {unit, cross(normal, unit)};
}

/// Share of the smaller face that both have in common, seen along the normal of the first.
double commonShare(const Facet& one, const Facet& other) {
  if (one.corners.size() == 2) {
    const base::Vector3 tangent{-one.normal[1], one.normal[0], 0.0};
    const auto span = [&](const Facet& facet) {
      return std::minmax({dot(facet.corners[0], tangent), dot(facet.corners[1], tangent)});
    };
    const auto [a, b] = span(one);
    const auto [c, d] = span(other);
    return std::max(0.0, std::min(b, d) - std::max(a, c)) / std::max(std::min(b - a, d - c), 1e-300);
  }
  const auto [first, second] = across(one.normal);
  const auto flat = [&, first = first, second = second](const Facet& facet) {
    Polygon polygon;
    for (const base::Vector3& x : facet.corners) {
      const base::Vector3 arm = x - one.centre;
      geometry::append(polygon, Flat(dot(arm, first), dot(arm, second)));
    }
    geometry::correct(polygon);
    return polygon;
  };
  const Polygon a = flat(one), b = flat(other);
  std::vector<Polygon> common;
  geometry::intersection(a, b, common);
  double area = 0.0;
  for (const Polygon& part : common) area += geometry::area(part);
  return area / std::max(std::min(geometry::area(a), geometry::area(b)), 1e-300);
}

/// Largest distance of a corner of `facet` from the plane of `other`.
double distanceFrom(const Facet& other, const Facet& facet) {
  double largest = 0.0;
  for (const base::Vector3& x : facet.corners)
    largest = std::max(largest, std::abs(dot(x - other.centre, other.normal)));
  return largest;
}

bool hasCornerAt(const Facet& facet, const base::Vector3& x, double tolerance) {
  return std::any_of(facet.corners.begin(), facet.corners.end(),
                     [&](const base::Vector3& y) { return distance(x, y) <= tolerance; });
}

/// Facets of two meshes of one curved surface: they touch in a node and hardly deviate. Where all corners are close,
/// a gap opens between equal meshes.
bool areOfOneCurvedSurface(const Facet& one, const Facet& other, double apart) {
  const auto haveCornersIn = [&](double tolerance) {
    return [&other, tolerance](const base::Vector3& x) { return hasCornerAt(other, x, tolerance); };
  };
  const double edge = std::min(one.edge, other.edge);
  return apart <= sagitta * std::max(one.edge, other.edge) &&
         std::any_of(one.corners.begin(), one.corners.end(), haveCornersIn(touching * edge)) &&
         !std::all_of(one.corners.begin(), one.corners.end(), haveCornersIn(close * edge));
}

bool lieOnEachOther(const Facet& one, const Facet& other) {
  if (-dot(one.normal, other.normal) < facing) return false;
  const double apart = one.edge < other.edge ? distanceFrom(other, one) : distanceFrom(one, other);
  const bool areInOnePlane = apart <= touching * std::min(one.edge, other.edge);
  return (areInOnePlane || areOfOneCurvedSurface(one, other, apart)) && commonShare(one, other) > leastOverlap;
}

/// Of faces without a partner: index into `side1`, index into `side2`.
std::vector<std::pair<int, int>> overlappingFaces(const Mesh& mesh, const std::vector<Face>& side1,
                                                  const std::vector<bool>& isMatched1, const std::vector<Face>& side2,
                                                  const std::vector<bool>& isMatched2) {
  std::vector<Facet> facets;
  std::vector<std::pair<Box3, int>> boxes;
  for (std::size_t j = 0; j < side2.size(); ++j) {
    facets.emplace_back(mesh, side2[j]);
    if (!isMatched2[j]) boxes.emplace_back(facets.back().box(), static_cast<int>(j));
  }
  const geometry::index::rtree<std::pair<Box3, int>, geometry::index::quadratic<16>> tree(boxes);
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < side1.size(); ++i) {
    if (isMatched1[i]) continue;
    const Facet one(mesh, side1[i]);
    std::vector<std::pair<Box3, int>> near;
    tree.query(geometry::index::intersects(one.box()), std::back_inserter(near));
    std::vector<int> found;
    for (const auto& [box, other] : near) {
      if (lieOnEachOther(one, facets[other])) found.push_back(other);
    }
    std::sort(found.begin(), found.end());
    for (const int other : found) pairs.emplace_back(static_cast<int>(i), other);
  }
  return pairs;
}

}  // namespace

FaceOverlap findOverlap(const Mesh& mesh, const std::vector<Face>& side1, const std::vector<Face>& side2,
                        const std::vector<FacePair>& matched) {
  std::vector<bool> isMatched1(side1.size(), false), isMatched2(side2.size(), false);
  for (const FacePair& pair : matched) isMatched1[pair.face1] = isMatched2[pair.face2] = true;
  const auto pairs = overlappingFaces(mesh, side1, isMatched1, side2, isMatched2);
  std::set<int> faces1, faces2;
  for (const auto& [i, j] : pairs) {
    faces1.insert(i);
    faces2.insert(j);
  }
  FaceOverlap overlap;
  overlap.faces1.assign(faces1.begin(), faces1.end());
  overlap.faces2.assign(faces2.begin(), faces2.end());
  return overlap;
}

}  // namespace harmos::mesh
