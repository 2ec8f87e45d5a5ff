#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// The inverse of an operator restricted to some rows, its trace, as a dense Cholesky factor of the Schur complement of
/// the other rows: B A^-1 B^T = P^T (L L^T)^-1 P.
struct TraceFactor {
  std::vector<int> order;  ///< position in the trace of each row of L
  base::Matrix lower;      ///< L; zero above the diagonal

  /// x = B A^-1 B^T b, column by column, rows in the order of the trace; different objects.
  void solve(const base::Matrix& b, base::Matrix& x) const;
};

}  // namespace harmos::substructure
