#pragma once

#include <Teuchos_SerialDenseMatrix.hpp>

#include <harmos/substructure/TraceFactor.hpp>

namespace harmos::substructure {

/// B A^-1 B^T [length/force] of a TraceFactor as a dense matrix, in double and in single precision: faster to apply
/// than the factor, and dearer to make than it.
class TraceInverse {
 public:
  /// Keeps nothing of the factor. Throws base::Error when it is singular.
  explicit TraceInverse(const TraceFactor& factor);

  /// Of the trace.
  int rows() const { return inverse_.numRows(); }
  /// x = B A^-1 B^T b, as TraceFactor::solve().
  void solve(const base::Matrix& b, base::Matrix& x) const;
  /// The same in single precision, to about six digits. A column by itself is bound by the memory that is read, a
  /// quarter of that of solve(); three or more read half of it together.
  void solveRoughly(const base::Matrix& b, base::Matrix& x) const;

 private:
  using Rough = Teuchos::SerialDenseMatrix<int, float>;

  base::Matrix inverse_;  // rows in the order of the trace
  Rough rough_;           // the same
};

}  // namespace harmos::substructure
