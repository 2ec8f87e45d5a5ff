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
  std::vector<const Corner*> ofCells;               // one after the other
  for (const Cell& cell : cells) {
    for (int c = 0; c < cell.count; ++c) {
      const auto [entry, isNew] = corners.try_emplace(cell.corner[c]);
      Corner& corner = entry->second;
      ofCells.push_back(&corner);
      if (isNew) corner.first = cell.normal;
      corner.sum = corner.sum + cell.normal;
      corner.isSmooth = corner.isSmooth && dot(corner.first, cell.normal) >= leastCosine;
    }
  }
  double largest = 0.0;
  for (auto& [place, corner] : corners) corner.sum = (1.0 / norm(corner.sum)) * corner.sum;
  for (std::size_t i = 0, k = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    for (int c = 0; c < cell.count; ++c) {
      for (int d = 0; d < c; ++d) {
        const Corner &one = *ofCells[k + c], &other = *ofCells[k + d];
        if (!one.isSmooth || !other.isSmooth) continue;
        largest = std::max(largest, std::abs(dot(one.sum - other.sum, cell.corner[c] - cell.corner[d])) / 8.0);
      }
    }
    k += cell.count;
  }
  return largest;
}

}  // namespace harmos::mortar
