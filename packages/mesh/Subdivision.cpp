#include <harmos/mesh/detail/Subdivision.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace harmos::mesh {
namespace {

using Corners = std::vector<base::Vector3>;

constexpr double samePlace = 1e-9;

int numberOf(const base::Vector3& place, std::vector<base::Vector3>& places) {
  const auto found = std::find_if(places.begin(), places.end(),
                                  [&](const base::Vector3& other) { return base::distance(place, other) < samePlace; });
  if (found != places.end()) return static_cast<int>(found - places.begin());
  places.push_back(place);
  return static_cast<int>(places.size()) - 1;
}

base::Vector3 middle(const base::Vector3& a, const base::Vector3& b) {
  return 0.5 * (a + b);
}

/// Half as large, around each corner.
std::vector<Corners> aroundCorners(const Corners& corners) {
  std::vector<Corners> children;
  for (const base::Vector3& own : corners) {
    Corners& child = children.emplace_back();
    for (const base::Vector3& corner : corners) child.push_back(middle(own, corner));
  }
  return children;
}

/// The triangle between the middles of the sides of another.
Corners innerTriangle(const base::Vector3& a, const base::Vector3& b, const base::Vector3& c) {
  return {middle(b, c), middle(c, a), middle(a, b)};
}

/// The tetrahedra of the octahedron between the middles of edges, around one of its diagonals.
std::vector<Corners> octahedron(const Corners& corners, std::size_t diagonal) {
  // Opposite edges of the tetrahedron, and the others in a circle around them.
  static constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static constexpr int ends[3][2] = {{0, 5}, {1, 3}, {2, 4}};
  static constexpr int circle[3][4] = {{2, 3, 4, 1}, {0, 2, 5, 4}, {0, 1, 5, 3}};
  const auto at = [&](int edge) { return middle(corners[edges[edge][0]], corners[edges[edge][1]]); };
  std::vector<Corners> children;
  for (std::size_t i = 0; i < 4; ++i) {
    Corners child = {at(ends[diagonal][0]), at(ends[diagonal][1]), at(circle[diagonal][i]),
                     at(circle[diagonal][(i + 1) % 4])};
    if (dot(cross(child[1] - child[0], child[2] - child[0]), child[3] - child[0]) < 0.0) std::swap(child[2], child[3]);
    children.push_back(std::move(child));
  }
  return children;
}

}  // namespace

Subdivision::Subdivision(ElementType parent, ElementType childType, const std::vector<Corners>& cornersOfChildren)
    : type(childType) {
  const ShapeFunctions inChild = shapeFunctions(linearType(childType), nodePlaces(childType));
  for (const Corners& child : cornersOfChildren) {
    std::vector<int>& nodes = children.emplace_back();
    for (int node = 0; node < inChild.points; ++node) {
      base::Vector3 place{};
      for (int a = 0; a < inChild.nodes; ++a) place = place + inChild.value[node * inChild.nodes + a] * child[a];
      nodes.push_back(numberOf(place, places));
    }
  }
  geometry = shapeFunctions(parent, places);
  corners = shapeFunctions(linearType(parent), places);
  for (int side = 0; side < sidesPerElement(parent); ++side) {
    const std::vector<int>& own = sideNodes(linearType(parent), side);
    const auto isOnSide = [&](int place) {
      double sum = 0.0;
      for (const int corner : own) sum += corners.value[place * corners.nodes + corner];
      return std::abs(sum - 1.0) < samePlace;
    };
    auto& parts = sides.emplace_back();
    for (std::size_t child = 0; child < children.size(); ++child) {
      for (int part = 0; part < sidesPerElement(childType); ++part) {
        const std::vector<int>& nodes = sideNodes(childType, part);
        if (std::all_of(nodes.begin(), nodes.end(), [&](int node) { return isOnSide(children[child][node]); })) {
          parts.emplace_back(static_cast<int>(child), part);
        }
      }
    }
  }
}

std::vector<std::vector<Corners>> splits(ElementType type) {
  if (type == ElementType::pyramid5) return {};
  const Corners corners = nodePlaces(linearType(type));
  std::vector<Corners> children = aroundCorners(corners);
  std::vector<std::vector<Corners>> choices;
  switch (linearType(type)) {
    case ElementType::tri3:
      children.push_back(innerTriangle(corners[0], corners[1], corners[2]));
      break;
    case ElementType::wedge6: {
      const Corners below = innerTriangle(corners[0], corners[1], corners[2]);
      const Corners above = innerTriangle(corners[3], corners[4], corners[5]);
      Corners between;
      for (std::size_t i = 0; i < 3; ++i) between.push_back(middle(below[i], above[i]));
      children.push_back({below[0], below[1], below[2], between[0], between[1], between[2]});
      children.push_back({between[0], between[1], between[2], above[0], above[1], above[2]});
      break;
    }
    case ElementType::tet4:
      for (std::size_t diagonal = 0; diagonal < 3; ++diagonal) {
        choices.push_back(children);
        const auto inner = octahedron(corners, diagonal);
        choices.back().insert(choices.back().end(), inner.begin(), inner.end());
      }
      return choices;
    default:
      break;
  }
  return {children};
}

}  // namespace harmos::mesh
