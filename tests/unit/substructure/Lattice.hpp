#pragma once

#include <cstddef>
#include <vector>

#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {

/// Cube of n^3 nodes, neighbours joined by springs that couple the components: a stiffness matrix without elements.
/// Its null vectors are the translations; every node keeps its block of `dimension` components.
struct Lattice {
  int n;
  int dimension = 3;
  double stiffness = 1.0;

  int nodes() const { return n * n * n; }
  int dofs() const { return dimension * nodes(); }
  std::vector<int> neighbours(int node) const {
    const int stride[3] = {1, n, n * n};
    std::vector<int> result;
    for (int axis = 2; axis >= 0; --axis) {
      if (node / stride[axis] % n > 0) result.push_back(node - stride[axis]);
    }
    result.push_back(node);
    for (int axis = 0; axis < 3; ++axis) {
      if (node / stride[axis] % n < n - 1) result.push_back(node + stride[axis]);
    }
    return result;
  }
  double coupling(int row, int column) const { return stiffness * (row == column ? 2.0 : 0.5); }

  Teuchos::RCP<base::CrsMatrix> matrix() const {
    std::vector<std::size_t> pointers{0};
    std::vector<int> columns;
    std::vector<double> values;
    for (int node = 0; node < nodes(); ++node) {
      const std::vector<int> near = neighbours(node);
      for (int i = 0; i < dimension; ++i) {
        for (const int other : near) {
          const double weight = other == node ? static_cast<double>(near.size()) - 1.0 : -1.0;
          for (int j = 0; j < dimension; ++j) {
            columns.push_back(dimension * other + j);
            values.push_back(weight * coupling(i, j));
          }
        }
        pointers.push_back(columns.size());
      }
    }
    return makeCrsMatrix(pointers, columns, values);
  }
};

}  // namespace harmos::substructure
