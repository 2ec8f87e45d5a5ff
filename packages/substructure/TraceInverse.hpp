#pragma once

#include <harmos/substructure/SymmetricTriangle.hpp>
#include <harmos/substructure/TraceFactor.hpp>

namespace harmos::substructure {

/// B A^-1 B^T [length/force] of a TraceFactor as a dense matrix, in double and in single precision: faster to apply
/// than the factor, and dearer to make than it.
class TraceInverse {
 public:
  /// Keeps nothing of the factor. Throws base::Error when it is singular.
  explicit TraceInverse(const TraceFactor& factor);

  /// Of the trace.
  int rows() const { return exact_.rows(); }
  /// x = B A^-1 B^T b, as TraceFactor::solve().
  void solve(const base::Matrix& b, base::Matrix& x) const { exact_.multiply(b, x); }
  /// The same in single precision, to about six digits. Reads half of the memory of solve(), for twice the columns.
  void solveRoughly(const base::Matrix& b, base::Matrix& x) const { rough_.multiply(b, x); }

 private:
  // Rows in the order of the trace.
  SymmetricTriangle<double> exact_;
  SymmetricTriangle<float> rough_;
};

}  // namespace harmos::substructure
