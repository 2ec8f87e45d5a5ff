#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// The largest of numbers, of which there is one at least.
inline double largest(const std::vector<double>& numbers) {
  return *std::max_element(numbers.begin(), numbers.end());
}

/// The largest size of so many numbers; 0 of none.
inline double largestOf(const double* values, int count) {
  double largest = 0.0;
  for (int row = 0; row < count; ++row) largest = std::max(largest, std::abs(values[row]));
  return largest;
}

/// That of the entries of a matrix.
inline double largestOf(const base::Matrix& matrix) {
  double largest = 0.0;
  for (int j = 0; j < matrix.numCols(); ++j) largest = std::max(largest, largestOf(matrix[j], matrix.numRows()));
  return largest;
}

}  // namespace harmos::latin
