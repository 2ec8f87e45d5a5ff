#include <harmos/mortar/detail/FacingCells.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

// Without the older rescaling of coordinates to integers, of which g++ 12 believes that it reads what is not set.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace harmos::mortar {
namespace {

namespace geometry = boost::geometry;
using Corner = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Corner>;

// Cosine of 40 degrees: the facets of a hexagon and of one that is turned against it are within 30 degrees.
constexpr double facing = 0.766;

/// Around a cell and what is within reach of it along its normal.
Box boxOf(const Cell& cell, const Reach& reach) {
  const double away = reach.distance ? *reach.distance : reach.relative * cell.size;
  base::Vector3 lower = cell.corner[0], upper = cell.corner[0];
  for (int i = 0; i < cell.count; ++i) {
    for (int d = 0; d < 3; ++d) {
      const double margin = std::abs(cell.normal[d]) * away;
      lower[d] = std::min(lower[d], cell.corner[i][d] - margin);
      upper[d] = std::max(upper[d], cell.corner[i][d] + margin);
    }
  }
  return {Corner(lower[0], lower[1], lower[2]), Corner(upper[0], upper[1], upper[2])};
}

}  // namespace

FacingCells findFacingCells(const std::vector<Cell>& side1, const std::vector<Cell>& side2, const Reach& reach) {
  std::vector<std::pair<Box, int>> boxes;
  for (std::size_t j = 0; j < side2.size(); ++j) boxes.emplace_back(boxOf(side2[j], reach), static_cast<int>(j));
  const geometry::index::rtree<std::pair<Box, int>, geometry::index::linear<16>> tree(boxes);
  FacingCells found;
  std::vector<std::pair<Box, int>> near;
  for (std::size_t i = 0; i < side1.size(); ++i) {
    near.clear();
    tree.query(geometry::index::intersects(boxOf(side1[i], reach)), std::back_inserter(near));
    const std::size_t before = found.pairs.size();
    for (const auto& candidate : near) {
      const double cosine = -dot(side1[i].normal, side2[candidate.second].normal);
      if (cosine >= facing) found.pairs.emplace_back(static_cast<int>(i), candidate.second);
      if (cosine <= -facing) ++found.lookingTheSameWay;
    }
    std::sort(found.pairs.begin() + static_cast<std::ptrdiff_t>(before), found.pairs.end());
  }
  return found;
}

bool areWithinReach(const Cell& one, const Cell& other, double apart, const Reach& reach) {
  return std::abs(apart) <= (reach.distance ? *reach.distance : reach.relative * std::max(one.size, other.size));
}

}  // namespace harmos::mortar
