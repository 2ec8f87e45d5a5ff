#pragma once

#include <cstddef>
#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// A dense lower triangular matrix L, stored without most of what lies above its diagonal.
///
/// Panels of columns stand one after the other, each from its first row on and column-major, so that a solve streams
/// every entry once through BLAS: half the memory of a square, and a solve that is bound by memory reads no more.
class LowerTriangle {
 public:
  /// Columns of a panel, but for the last one.
  static constexpr int width = 96;

  /// All zero.
  explicit LowerTriangle(int rows = 0);

  /// Of the matrix, as many as its columns.
  int rows() const { return rows_; }
  /// Numbers stored.
  std::size_t entries() const { return values_.size(); }
  /// The entry at `row` >= `column`.
  double& operator()(int row, int column) { return values_[at(row, column)]; }
  /// The same, to be read.
  double operator()(int row, int column) const { return values_[at(row, column)]; }

  /// y := L^-1 y, column by column. The diagonal must not have zeros, which is not checked.
  void solve(base::Matrix& y) const;
  /// y := L^-T y.
  void solveTransposed(base::Matrix& y) const;

 private:
  int panels() const { return (rows_ + width - 1) / width; }
  /// Columns of a panel.
  int columnsOf(int panel) const;
  /// Numbers before a panel.
  std::size_t offsetOf(int panel) const;
  std::size_t at(int row, int column) const;
  /// y := D^-1 y with the triangle D at the top of a panel, or D^-T y, for the rows of D.
  void solveDiagonal(int panel, bool isTransposed, base::Matrix& y) const;

  int rows_;
  std::vector<double> values_;
};

}  // namespace harmos::substructure
