#include <harmos/mortar/detail/BeyondReach.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/mortar/detail/FacingCells.hpp>

namespace harmos::mortar {
namespace {

constexpr double farther = 10.0;
constexpr double leastCommon = 0.1;  // area over that of the smaller cell: faces side by side share no more

std::vector<Cell> leftCells(const std::vector<Cell>& cells, const std::set<int>& joined) {
  std::vector<Cell> left;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(left),
               [&](const Cell& cell) { return joined.count(cell.face) == 0; });
  return left;
}

}  // namespace

BeyondReach findBeyondReach(int dimension, const std::array<const std::vector<Cell>*, 2>& cells,
                            const std::array<std::set<int>, 2>& joined, const Reach& reach) {
  const std::array<std::vector<Cell>, 2> left = {leftCells(*cells[0], joined[0]), leftCells(*cells[1], joined[1])};
  if (left[0].empty() || left[1].empty()) return {};
  Reach wide = reach;
  wide.relative *= farther;
  if (wide.distance) *wide.distance *= farther;
  std::array<std::set<int>, 2> faces;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : findFacingCells(left[0], left[1], wide).pairs) {
    const Cell &one = left[0][i], &other = left[1][j];
    const Plane plane(one.centre, one.normal, dimension);
    const ConvexPolygon common = intersection(one.on(plane), other.on(plane));
    if (common.corners() == 0 || common.area() < leastCommon * std::min(one.area, other.area)) continue;
    const double apart = std::abs(plane.heightOf(other.centre, other.normal, common.middle()));
    if (!areWithinReach(one, other, apart, wide)) continue;
    faces[0].insert(one.face);
    faces[1].insert(other.face);
    nearest = std::min(nearest, apart);
  }
  if (faces[0].empty()) return {};
  return {{static_cast<int>(faces[0].size()), static_cast<int>(faces[1].size())}, nearest};
}

}  // namespace harmos::mortar
