#pragma once

#include <stdexcept>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>

namespace harmos::substructure {

/// A x = b by conjugate gradients (Belos) preconditioned with algebraic multigrid, for a matrix A [force/length] that
/// is symmetric and positive definite and too large to be factored: it takes memory in proportion to its entries.
///
/// A column is solved when its energy error |x - A^-1 b|_A / |A^-1 b|_A is below the tolerance [-], which is found from
/// the true residual r = b - A x: its square is r.M^-1 r / b.x times what M^-1, the preconditioner, underestimates by.
class IterativeSolver {
 public:
  /// A column has not come near the tolerance.
  class NotConverged : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
  };

  /// The matrix is shared. nearKernel and components: see multigridLibrary(), which has to be there.
  IterativeSolver(const Teuchos::RCP<const base::CrsMatrix>& matrix, const Teuchos::RCP<base::MultiVector>& nearKernel,
                  int components, double tolerance);
  /// Frees the preconditioner.
  ~IterativeSolver();

  /// x [length] from b [force], of the same shape, any number of columns, different objects; where x is given nearer to
  /// the solution than 0, fewer iterations are needed. Throws NotConverged, also when A is not positive definite.
  void solve(const base::Matrix& b, base::Matrix& x) const;
  /// r = b - A x [force], of the same shape.
  base::Matrix residual(const base::Matrix& b, const base::Matrix& x) const;
  /// Iterations of all columns since construction.
  long iterations() const { return iterations_; }

 private:
  void solveColumn(base::MultiVector& left, const base::MultiVector& right) const;
  double energyError(const base::MultiVector& left, const base::MultiVector& right) const;

  Teuchos::RCP<const base::CrsMatrix> matrix_;
  Teuchos::RCP<const base::Operator> multigrid_;
  double tolerance_;
  mutable double target_;  // relative residual that has sufficed so far
  mutable long iterations_ = 0;
};

}  // namespace harmos::substructure
