#pragma once

#include <cstddef>
#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// A supernodal Cholesky factor P A P^T = L L^T in single precision: solves read half as much memory as in double. The
/// relative error of a solution is about 6e-8 times the square root of the condition of A to 6e-8 times the condition;
/// whoever uses it must know it, see SubstructureSolver::singleError().
///
/// Supernode s: columns firstColumn[s] to firstColumn[s + 1] of L, whose entries stand in the rows
/// row[firstRow[s]] ... row[firstRow[s + 1] - 1], the first of them the columns themselves; values by columns from
/// firstValue[s]. With T the triangle of a supernode and B the rows below it, solves take the panel [T^-1; B T^-1]: one
/// product forward, one backward, each of which reads it once, where triangular solves of few columns are slow.
/// Sources: Chen, Davis, Hager, Rajamanickam (2008), doi:10.1145/1391989.1391995; selective inversion: Raghavan,
/// Parallel Processing Letters 8 (1998).
struct SingleFactor {
  std::vector<int> order;               ///< row of A of each row of L
  std::vector<int> firstColumn;         ///< of every supernode, and the number of all
  std::vector<int> firstRow;            ///< in `row` of every supernode, and its length
  std::vector<int> row;                 ///< of L, of all entries
  std::vector<std::size_t> firstValue;  ///< in `value` of every supernode, and its length
  std::vector<float> value;             ///< of the entries, supernode by supernode; of panels after invertTriangles()

  /// Makes panels of the entries of L; to be called once, before solve().
  void invertTriangles();
  /// x = A^-1 b, both in double and of the same shape, any number of columns; different objects. Columns are scaled to
  /// 1, so that they may be of any size.
  void solve(const base::Matrix& b, base::Matrix& x) const;
  /// What it holds [byte].
  std::size_t memory() const;
};

}  // namespace harmos::substructure
