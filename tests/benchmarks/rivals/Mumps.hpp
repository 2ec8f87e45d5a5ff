#pragma once

#include <vector>

#include <dmumps_c.h>

#include <harmos/base/Matrix.hpp>

#include "SparseMatrix.hpp"

namespace harmos::benchmarks {

/// A sparse matrix factored by MUMPS, in the order of METIS; on the calling process alone. Throws base::Error when
/// MUMPS reports one.
///
/// Source: Amestoy, Duff, L'Excellent, Koster (2001), doi:10.1137/S0895479899358194.
class Mumps {
 public:
  enum class Kind { positiveDefinite, general };
  /// Analyses the structure, which is copied. `last`: so many rows at the end are not factored; their Schur complement
  /// is computed.
  Mumps(const SparseMatrix& structure, Kind kind, int last = 0);
  ~Mumps();
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Factors the matrix, which has the structure that was analysed.
  void factor(const SparseMatrix& matrix);
  /// Of the last rows, whole; owned by this object until the next factor(). Callers may take it.
  base::Matrix& schur() { return schur_; }
  /// x: right sides, one per column, which become the solutions. Without rows that are not factored.
  void solve(base::Matrix& x);
  /// Right sides of all rows become K_uu^-1 f_u above and the condensed f_w - K_wu K_uu^-1 f_u in the last rows.
  void condense(base::Matrix& f);

 private:
  void run(int job);

  DMUMPS_STRUC_C mumps_{};
  Kind kind_;
  int last_;
  std::vector<int> rows_, columns_, order_, lastRows_;
  std::vector<double> values_;
  base::Matrix schur_;
};

}  // namespace harmos::benchmarks
