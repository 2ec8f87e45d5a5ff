#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
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
  int rows() const { return static_cast<int>(order_.size()); }
  /// x = B A^-1 B^T b, as TraceFactor::solve().
  void solve(const base::Matrix& b, base::Matrix& x) const;
  /// The same in single precision, to about six digits. Reads half of the memory of solve(), for twice the columns.
  void solveRoughly(const base::Matrix& b, base::Matrix& x) const;

 private:
  template <class Triangle>
  void apply(const Triangle& triangle, const base::Matrix& b, base::Matrix& x) const;

  std::vector<int> order_;  // position in the trace of each row of the factor
  SymmetricTriangle<double> exact_;
  SymmetricTriangle<float> rough_;
};

}  // namespace harmos::substructure
