#pragma once

#include <array>
#include <set>
#include <vector>

#include <harmos/mortar/Reach.hpp>
#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// Faces that lie opposite each other, but too far apart to be joined.
struct BeyondReach {
  std::array<int, 2> faces{};  // of both sides
  double nearest = 0.0;        // least distance of two of them along the normals [length]; 0 where there are none
};

/// Those of both sides that are not `joined` to any other, up to ten times the reach. O(n log n) for n of them.
BeyondReach findBeyondReach(int dimension, const std::array<const std::vector<Cell>*, 2>& cells,
                            const std::array<std::set<int>, 2>& joined, const Reach& reach);

}  // namespace harmos::mortar
