#pragma once

#include <memory>
#include <vector>

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::substructure {

/// Addends of a sparse symmetric matrix, of its lower triangle: repeated ones add up, also those of several ranks.
struct SymmetricEntries {
  std::vector<int> rows;       ///< from 0
  std::vector<int> columns;    ///< from 0, at most the row
  std::vector<double> values;  ///< in the unit of the matrix
};

/// A symmetric, positive definite matrix A [any unit] that no rank has as a whole: each gives some addends of its
/// entries, and all factor it together and keep a share of the factor (MUMPS).
///
/// Source: Amestoy, Duff, L'Excellent, Koster (2001), doi:10.1137/S0895479899358194.
class DistributedSolver {
 public:
  /// A is singular or indefinite.
  class NotPositiveDefinite : public base::Error {
   public:
    using base::Error::Error;
  };

  /// Whether this build has it; without MUMPS it has not, and nothing else here may be called.
  static bool exists();

  /// Collective over `comm`, which is kept: sums up and factors what all ranks give, and checks it with one solve.
  /// Throws the same on all ranks: NotPositiveDefinite, or base::Error when memory does not suffice.
  DistributedSolver(int rows, SymmetricEntries addends, Teuchos::RCP<const Teuchos::Comm<int>> comm);
  /// Frees the factor, collectively. Where an exception ends one rank alone it does not: that would wait for the others
  /// without end.
  ~DistributedSolver();
  DistributedSolver(const DistributedSolver&) = delete;
  DistributedSolver& operator=(const DistributedSolver&) = delete;

  /// Collective. x = A^-1 b, column by column; b is the same on all ranks, and so is x, to the last digit. Different
  /// objects; x gets the shape of b.
  void solve(const base::Matrix& b, base::Matrix& x) const;

 private:
  struct Mumps;
  bool isPositive(const SymmetricEntries& addends) const;

  int rows_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  std::unique_ptr<Mumps> mumps_;
};

}  // namespace harmos::substructure
