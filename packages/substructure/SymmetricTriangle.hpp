#pragma once

#include <cstddef>
#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// A dense symmetric matrix of numbers in single or double precision, of which one triangle is stored, and its product
/// with a few columns.
///
/// BLAS has no such product for columns together: its matrix products first copy the matrix, all of it, which takes
/// twice as long as a product with eight columns. Here the triangle is read once for as many columns as a vector
/// register of the processor has numbers, up to sixteen in single and eight in double precision; each entry serves the
/// row and the column that it stands for.
template <class Number>
class SymmetricTriangle {
 public:
  /// All zero.
  explicit SymmetricTriangle(int rows = 0);

  /// Of the matrix, as many as its columns.
  int rows() const { return rows_; }
  /// Numbers stored.
  std::size_t entries() const { return values_.size(); }
  /// Sets the entries at (row, column) and (column, row).
  void set(int row, int column, double value);
  /// x = A b, both of rows(); sums are of the precision of the numbers.
  void multiply(const base::Matrix& b, base::Matrix& x) const;

 private:
  std::size_t at(int row, int column) const;

  int rows_;
  int height_;                  // rows with those that fill the last panel
  std::vector<Number> values_;  // panels of columns, each from its first row on, column-major
};

extern template class SymmetricTriangle<float>;
extern template class SymmetricTriangle<double>;

}  // namespace harmos::substructure
