#include <harmos/mortar/detail/MortarSide.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace harmos::mortar {
namespace {

constexpr double equal = 1e-2;  // relative difference of two sizes that is none
// How many times softer a side is that carries the points whatever the meshes: the nodes of a rigid one cannot give
// way, and pressures on them oscillate where the other mesh is coarser.
constexpr double soft = 3.0;
// Share of the faces of a side that the other one covers at most, below which it would be held up by corners beside it.
constexpr double leastCovered = 0.9;

/// -1 if the first is clearly smaller, 1 if the second is, 0 if none.
int smaller(const std::array<double, 2>& size) {
  if (std::abs(size[0] - size[1]) <= equal * std::max(size[0], size[1])) return 0;
  return size[0] < size[1] ? -1 : 1;
}

}  // namespace

int chooseMortarSide(int dimension, const std::array<const std::vector<Cell>*, 2>& cells,
                     const std::vector<std::pair<int, int>>& pairs, const std::array<double, 2>& stiffness) {
  std::array<double, 2> faceSize{}, area{};
  for (int side = 0; side < 2; ++side) {
    std::vector<bool> isFacing(cells[side]->size(), false);
    for (const auto& pair : pairs) isFacing[side == 0 ? pair.first : pair.second] = true;
    std::set<int> faces;
    for (std::size_t c = 0; c < isFacing.size(); ++c) {
      if (isFacing[c]) faces.insert((*cells[side])[c].face);
    }
    for (const Cell& cell : *cells[side]) {
      if (faces.count(cell.face) > 0) area[side] += cell.area;
    }
    if (faces.empty()) continue;
    faceSize[side] = std::pow(area[side] / static_cast<double>(faces.size()), dimension == 3 ? 0.5 : 1.0);
  }
  for (int side = 0; side < 2; ++side) {
    if (area[side] < leastCovered * area[1 - side]) return side;
  }
  if (stiffness[0] > soft * stiffness[1]) return 1;
  if (stiffness[1] > soft * stiffness[0]) return 0;
  if (const int which = smaller(faceSize)) return which < 0 ? 1 : 0;
  for (const auto& size : {stiffness, area}) {
    if (const int which = smaller(size)) return which < 0 ? 0 : 1;
  }
  return 0;
}

}  // namespace harmos::mortar
