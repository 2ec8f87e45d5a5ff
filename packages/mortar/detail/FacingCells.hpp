#pragma once

#include <utility>
#include <vector>

#include <harmos/mortar/Reach.hpp>
#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// Cells of two sides that may have a part in common: they face each other, and one is within reach of the other.
struct FacingCells {
  std::vector<std::pair<int, int>> pairs;  // indices into both lists, ascending
  int lookingTheSameWay = 0;               // pairs within reach whose normals are not opposite
};

/// Finds them by a tree of boxes (Boost.Geometry), in O(n log n) for n cells of similar size. `reach` [length] along
/// the normals; none: of every cell its longest edge.
FacingCells findFacingCells(const std::vector<Cell>& side1, const std::vector<Cell>& side2, const Reach& reach);

/// Whether two cells are within reach at a place where the distance along the normal is `apart` [length].
bool areWithinReach(const Cell& one, const Cell& other, double apart, const Reach& reach);

}  // namespace harmos::mortar
