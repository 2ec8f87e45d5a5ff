#pragma once

#include <harmos/substructure/SingleTriangle.hpp>
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
  /// The same in single precision, to about six digits. Reads a quarter of the memory of solve(), once for up to
  /// sixteen columns.
  void solveRoughly(const base::Matrix& b, base::Matrix& x) const { rough_.multiply(b, x); }

 private:
  base::Matrix inverse_;  // rows in the order of the trace
  SingleTriangle rough_;  // the same
};

}  // namespace harmos::substructure
