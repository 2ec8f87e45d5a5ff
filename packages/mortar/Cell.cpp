#include <harmos/mortar/detail/Cell.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::mortar {
namespace {

constexpr double straight = 1e-9;  // distance of a node from the line between corners, over its length

base::Vector3 positionOf(const FaceShape& shape, const std::vector<base::Vector3>& points,
                         const std::vector<int>& nodes, const Parent& at) {
  const auto values = shape.values(at);
  base::Vector3 sum{};
  for (int j = 0; j < shape.nodes(); ++j) sum = sum + values[j] * points[nodes[j]];
  return sum;
}

/// Whether the corners alone tell where the face is.
bool hasStraightEdges(const FaceShape& shape, const std::vector<base::Vector3>& points, const std::vector<int>& nodes) {
  const int corners = shape.corners();
  base::Vector3 centre{};
  double size = 0.0;
  for (int i = 0; i < corners; ++i) {
    const base::Vector3& from = points[nodes[i]];
    const base::Vector3 along = points[nodes[(i + 1) % corners]] - from;
    const base::Vector3 arm = points[nodes[corners + (corners == 2 ? 0 : i)]] - from;
    const double length = norm(along), share = dot(arm, along) / dot(along, along);
    if (!(norm(arm - share * along) <= straight * length) || share < 0.0 || share > 1.0) return false;
    centre = centre + (1.0 / corners) * from;
    size = std::max(size, length);
  }
  return shape.nodes() <= 2 * corners || distance(points[nodes.back()], centre) <= straight * size;
}

/// Centre, normal, area and size from the corners.
bool measure(Cell& cell, int dimension) {
  cell.centre = {};
  for (int i = 0; i < cell.count; ++i) cell.centre = cell.centre + (1.0 / cell.count) * cell.corner[i];
  base::Vector3 normal{};
  for (int i = 0; i < cell.count; ++i) {
    const base::Vector3& next = cell.corner[(i + 1) % cell.count];
    cell.size = std::max(cell.size, distance(cell.corner[i], next));
    normal = normal + 0.5 * cross(cell.corner[i] - cell.centre, next - cell.centre);
  }
  if (dimension == 2) normal = cross(cell.corner[1] - cell.corner[0], {0.0, 0.0, 1.0});
  cell.area = norm(normal);
  if (!(cell.area > 0.0)) return false;
  cell.normal = (1.0 / cell.area) * normal;
  return true;
}

}  // namespace

ConvexPolygon Cell::on(const Plane& plane) const {
  std::array<Flat, FaceShape::mostCorners> flat;
  for (int i = 0; i < count; ++i) flat[i] = plane.project(corner[i]);
  struct Range {
    const Flat *first, *last;
    const Flat* begin() const { return first; }
    const Flat* end() const { return last; }
  };
  return ConvexPolygon(Range{flat.data(), flat.data() + count});
}

std::vector<Cell> cellsOf(int dimension, const std::vector<base::Vector3>& points,
                          const std::vector<mesh::Face>& faces) {
  std::vector<Cell> cells;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<int>& nodes = faces[f].nodes;
    const FaceShape* shape = &FaceShape::of(dimension, nodes.size());
    const bool isCurved = shape->isQuadratic() && !hasStraightEdges(*shape, points, nodes);
    const FaceShape& corners = FaceShape::of(dimension, static_cast<std::size_t>(shape->corners()));
    for (const auto& part : (isCurved ? *shape : corners).parts()) {
      Cell cell;
      cell.face = static_cast<int>(f);
      cell.count = static_cast<int>(part.size());
      for (int i = 0; i < cell.count; ++i) {
        cell.corner[i] = isCurved ? positionOf(*shape, points, nodes, part[i]) : points[nodes[i]];
      }
      if (measure(cell, dimension)) cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace harmos::mortar
