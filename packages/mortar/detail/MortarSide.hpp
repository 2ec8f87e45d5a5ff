#pragma once

#include <array>
#include <utility>
#include <vector>

#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// Which side (0 or 1) carries the points unless the user says so: one that is more than ten times softer; else that
/// with the smaller mean face among those that may have a part in common; if they are equal within a hundredth, the
/// softer one; if these are equal, the one with the smaller surface; else side 1. `pairs`: of cells, as
/// findFacingCells() gives them.
int chooseMortarSide(int dimension, const std::array<const std::vector<Cell>*, 2>& cells,
                     const std::vector<std::pair<int, int>>& pairs, const std::array<double, 2>& stiffness);

}  // namespace harmos::mortar
