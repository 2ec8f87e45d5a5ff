#pragma once

#include <cstddef>
#include <vector>

namespace harmos::benchmarks {

/// A square matrix in compressed rows, both triangles, columns ascending.
struct SparseMatrix {
  std::vector<std::size_t> pointers{0};  ///< rows + 1: where each row begins
  std::vector<int> columns;              ///< from 0
  std::vector<double> values;            ///< [force/length]

  int rows() const { return static_cast<int>(pointers.size()) - 1; }
  /// The product of one row with a vector.
  double product(int row, const double* x) const {
    double sum = 0.0;
    for (std::size_t k = pointers[row]; k < pointers[row + 1]; ++k) sum += values[k] * x[columns[k]];
    return sum;
  }
};

}  // namespace harmos::benchmarks
