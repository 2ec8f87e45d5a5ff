#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/substructure/LowerTriangle.hpp>

namespace harmos::substructure {

/// The inverse of an operator restricted to some rows, its trace, as a dense Cholesky factor of the Schur complement of
/// the other rows: B A^-1 B^T = P^T (L L^T)^-1 P, with A [force/length] the operator, B the restriction to the trace
/// and P the permutation `order`.
struct TraceFactor {
  std::vector<int> order;       ///< position in the trace of each row of L
  LowerTriangle lower;          ///< L
  bool isToBeInverted = false;  ///< the solves that are expected are worth that, see SolverOptions::inverts()

  /// x = B A^-1 B^T b [length], column by column, b [force], rows in the order of the trace; different objects. x is
  /// reshaped when it does not have the shape of b, whose rows are not checked.
  void solve(const base::Matrix& b, base::Matrix& x) const;
};

}  // namespace harmos::substructure
