#pragma once

#include <cstddef>
#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// A supernodal Cholesky factor P A P^T = L L^T in single precision: solves read half as much memory as in double. The
/// relative error of a solution is about 6e-8 times the square root of the condition of A to 6e-8 times the condition;
/// whoever uses it must know it, see SubstructureSolver::singleError().
///
/// A supernode is some columns of L with entries in the same rows, the first of them the columns themselves. With T the
/// triangle of its columns and B the rows below it, solves take the panel [T^-1; B T^-1]: one product forward, one
/// backward, each of which reads it once, where triangular solves of few columns are slow. Wide supernodes are several
/// panels, so that few of the entries that are read are the zeros above the diagonals of T^-1.
/// Sources: Chen, Davis, Hager, Rajamanickam (2008), doi:10.1145/1391989.1391995; selective inversion: Raghavan,
/// Parallel Processing Letters 8 (1998).
class SingleFactor {
 public:
  /// `order`: row of A of each row of L. `entries`: of all supernodes that are added, for which there is room then.
  SingleFactor(const std::vector<int>& order, std::size_t entries);
  /// Appends the next supernode: so many columns of L from the last one on, whose entries stand in `height` rows of L,
  /// ascending, the first of them the columns; values: by columns, what is above the diagonal is not read.
  void add(int columns, int height, const int* rows, const double* values);

  /// Says for which rows of A, ascending, solveTrace() is, once all supernodes are added: panels that none of them
  /// needs are left out then.
  void setTrace(const std::vector<int>& rows);

  /// x = A^-1 b, both in double and of the same shape, any number of columns; different objects. Columns are scaled to
  /// 1, so that they may be of any size.
  void solve(const base::Matrix& b, base::Matrix& x) const { solve(b, x, false); }
  /// x = B A^-1 B^T b with B the restriction to the rows of setTrace(); as solve().
  void solveTrace(const base::Matrix& b, base::Matrix& x) const { solve(b, x, true); }
  /// Sends a copy to another rank, which must receive() it at the same time.
  void send(const Teuchos::Comm<int>& comm, int rank) const;
  /// What another rank sends.
  static SingleFactor receive(const Teuchos::Comm<int>& comm, int rank);
  /// Rows of setTrace().
  int traceRows() const { return static_cast<int>(trace_.size()); }
  /// Entries that solveTrace() reads twice.
  std::size_t traceEntries() const;
  /// What it holds [byte].
  std::size_t memory() const;

 private:
  struct Panel {
    int firstColumn, width;  // of L
    int firstRow, height;    // in rows_
    std::size_t firstValue;  // of its entries, by columns
    bool isOfTrace;          // has rows of the trace, or another panel that has some updates it
  };

  void solve(const base::Matrix& b, base::Matrix& x, bool isOfTrace) const;

  std::vector<int> place_;  // row of L of each row of A
  int columns_ = 0;         // of L, so far
  int tallest_ = 0;         // rows of a panel, at most
  std::vector<Panel> panels_;
  std::vector<int> rows_;      // of L; the panels of a supernode share them
  std::vector<float> values_;  // panel by panel
  std::vector<int> trace_;     // rows of L
};

}  // namespace harmos::substructure
