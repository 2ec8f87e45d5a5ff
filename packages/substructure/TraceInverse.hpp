#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/MirrorPlanes.hpp>
#include <harmos/substructure/SymmetricTriangle.hpp>
#include <harmos/substructure/TraceFactor.hpp>

namespace harmos::substructure {

/// B A^-1 B^T [length/force] of a TraceFactor as a dense matrix, in double and in single precision: faster to apply
/// than the factor, and dearer to make than it. Where it is its own mirror image it is kept in blocks, of which two
/// take half of the memory and of the time of the whole.
class TraceInverse {
 public:
  /// Keeps nothing of the factor. `rows`: what the rows of the trace stand for; empty: no mirror images are looked for.
  /// Throws base::Error when it is singular.
  explicit TraceInverse(const TraceFactor& factor, const std::vector<MirrorPlanes::Row>& rows = {});

  /// Of the trace.
  int rows() const { return static_cast<int>(order_.size()); }
  /// Numbers kept in each precision.
  std::size_t entries() const;
  /// x = B A^-1 B^T b, as TraceFactor::solve().
  void solve(const base::Matrix& b, base::Matrix& x) const;
  /// The same in single precision, to about six digits. Reads half of the memory of solve(), for twice the columns.
  void solveRoughly(const base::Matrix& b, base::Matrix& x) const;

 private:
  struct Block {
    std::vector<int> rows;  // of the factor, after the change
    SymmetricTriangle<double> exact;
    SymmetricTriangle<float> rough;
  };

  template <class Multiply>
  void apply(const base::Matrix& b, base::Matrix& x, const Multiply& multiply) const;

  std::vector<int> order_;  // position in the trace of each row of the factor
  MirrorPlanes planes_;
  std::vector<Block> blocks_;
};

}  // namespace harmos::substructure
