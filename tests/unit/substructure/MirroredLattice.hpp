#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {

/// The corners of uneven bricks that lie evenly about x = 1, y = 2 and z = 3, in an order as if by chance, neighbours
/// joined by springs with stiffness tensors as if by chance, which are the mirror images of each other in planes across
/// x and y. Null vectors are the translations.
class MirroredLattice {
 public:
  /// `unevenness`: of the stiffness of a spring, by which its mirror images are stiffer.
  explicit MirroredLattice(unsigned seed, double unevenness = 0.0) : random_(seed) {
    for (const double x : {-1.0, -0.3, 0.3, 1.0}) {
      for (const double y : {-2.0, -0.7, 0.0, 0.7, 2.0}) {
        for (const double z : {-1.0, -0.8, -0.6, 0.1, 0.4, 1.0}) nodes.push_back({1.0 + x, 2.0 + y, 3.0 + z});
      }
    }
    std::shuffle(nodes.begin(), nodes.end(), random_);
    std::vector<MatrixEntry> entries;
    for (int a = 0; a < count(); ++a) {
      for (int b = 0; b < a; ++b) {
        if (base::distance(nodes[a], nodes[b]) > 1.31) continue;
        // A sum of squares, and each mirror image of it.
        double factor[3][3];
        for (auto& row : factor) {
          for (double& entry : row) entry = number();
        }
        for (int mirrored = 0; mirrored < 4; ++mirrored) {
          const int ends[] = {image(a, mirrored), image(b, mirrored)};
          for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
              double value = 0.0;
              for (const auto& row : factor) value += sign(i, mirrored) * sign(j, mirrored) * row[i] * row[j];
              if (mirrored > 0) value *= 1.0 + unevenness;
              for (int end = 0; end < 2; ++end) {
                entries.push_back({3 * ends[end] + i, 3 * ends[end] + j, value});
                entries.push_back({3 * ends[end] + i, 3 * ends[1 - end] + j, -value});
              }
            }
          }
        }
      }
    }
    matrix = makeCrsMatrix(entries, rows());
  }

  int count() const { return static_cast<int>(nodes.size()); }
  int rows() const { return 3 * count(); }
  double number() { return random_() / 2147483648.0 - 1.0; }
  base::Matrix numbers(int rows, int columns) {
    base::Matrix result(rows, columns);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) result(i, j) = number();
    }
    return result;
  }
  /// Rows of the nodes with this coordinate, ascending.
  std::vector<int> rowsAt(std::size_t axis, double coordinate) const {
    std::vector<int> result;
    for (int row = 0; row < rows(); ++row) {
      if (std::abs(nodes[row / 3][axis] - coordinate) < 1e-12) result.push_back(row);
    }
    return result;
  }

  std::vector<base::Vector3> nodes;
  Teuchos::RCP<base::CrsMatrix> matrix;

 private:
  /// Across x (bit 1) and y (bit 2).
  int image(int node, int mirrored) const {
    base::Vector3 to = nodes[node];
    for (int axis = 0; axis < 2; ++axis) {
      if ((mirrored >> axis & 1) != 0) to[axis] = 2.0 * (1.0 + axis) - to[axis];
    }
    const auto at = std::find_if(nodes.begin(), nodes.end(),
                                 [&](const base::Vector3& other) { return base::distance(other, to) < 1e-12; });
    return static_cast<int>(at - nodes.begin());
  }
  static double sign(int component, int mirrored) {
    return component < 2 && (mirrored >> component & 1) != 0 ? -1.0 : 1.0;
  }

  std::mt19937 random_;
};

}  // namespace harmos::substructure
