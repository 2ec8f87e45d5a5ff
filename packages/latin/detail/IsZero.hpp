#pragma once

#include <algorithm>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// Whether all entries are zero; what is not a number is not.
inline bool isZero(const base::Matrix& matrix) {
  for (int j = 0; j < matrix.numCols(); ++j) {
    if (!std::all_of(matrix[j], matrix[j] + matrix.numRows(), [](double value) { return value == 0.0; })) return false;
  }
  return true;
}

}  // namespace harmos::latin
