#include <harmos/mortar/detail/Sagitta.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace harmos::mortar {
namespace {

/// Around a corner of cells.
struct Corner {
  base::Vector3 sum{};  // of the unit normals
  base::Vector3 first{};
  bool isSmooth = true;
};

}  // namespace

double sagittaOf(const std::vector<Cell>& cells, double creaseAngle) {
  const double leastCosine = std::cos(creaseAngle * std::acos(-1.0) / 180.0);
  std::map<std::array<double, 3>, Corner> corners;  // cells of one mesh have the very same ones
  for (const Cell& cell : cells) {
    for (int c = 0; c < cell.count; ++c) {
      const auto [entry, isNew] = corners.try_emplace(cell.corner[c]);
      Corner& corner = entry->second;
      if (isNew) corner.first = cell.normal;
      corner.sum = corner.sum + cell.normal;
      corner.isSmooth = corner.isSmooth && dot(corner.first, cell.normal) >= leastCosine;
    }
  }
  double largest = 0.0;
  for (const Cell& cell : cells) {
    for (int c = 0; c < cell.count; ++c) {
      for (int d = 0; d < c; ++d) {
        const Corner &one = corners.at(cell.corner[c]), &other = corners.at(cell.corner[d]);
        if (!one.isSmooth || !other.isSmooth) continue;
        const base::Vector3 turn = (1.0 / norm(one.sum)) * one.sum - (1.0 / norm(other.sum)) * other.sum;
        largest = std::max(largest, std::abs(dot(turn, cell.corner[c] - cell.corner[d])) / 8.0);
      }
    }
  }
  return largest;
}

}  // namespace harmos::mortar
