#pragma once

#include <array>
#include <utility>
#include <vector>

#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// Which side (0 or 1) carries the points unless the user says so: one whose faces are so much smaller that they cover
/// less than nine tenths of those of the other, whose corners would hold it up beside itself; else one that is more
/// than three times softer; else that with the larger mean face among those that may have a part in common, on whose
/// nodes tractions do not oscillate; if they are equal within a hundredth, the softer one; if these are equal, the one
/// with the smaller surface; else side 1. `pairs`: of cells, as findFacingCells() gives them.
int chooseMortarSide(int dimension, const std::array<const std::vector<Cell>*, 2>& cells,
                     const std::vector<std::pair<int, int>>& pairs, const std::array<double, 2>& stiffness);

}  // namespace harmos::mortar
