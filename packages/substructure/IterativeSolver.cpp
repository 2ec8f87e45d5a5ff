#include <harmos/substructure/IterativeSolver.hpp>

#include <algorithm>
#include <cmath>

#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>

#include <harmos/base/Numerals.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

namespace harmos::substructure {
namespace {

constexpr int maximumIterations = 1000;
// What the preconditioner may underestimate energy errors by.
constexpr double underestimate = 10.0;
// Relative residuals: the first that is tried, times the tolerance, how much less the next one is, and how many are.
constexpr double firstTarget = 0.3, tighter = 0.1;
constexpr int attempts = 4;
// Times the tolerance: where round-off keeps energy errors above it, solutions are still of use.
constexpr double bearable = 100.0;

using Vectors = base::MultiVector;

/// b - A x.
Vectors residualOf(const base::CrsMatrix& matrix, const Vectors& left, const Vectors& right) {
  Vectors residual(right, Teuchos::Copy);
  matrix.apply(left, residual, Teuchos::NO_TRANS, -1.0, 1.0);
  return residual;
}

double dot(const Vectors& a, const Vectors& b) {
  double value = 0.0;
  a.dot(b, Teuchos::arrayView(&value, 1));
  return value;
}

void copy(const double* from, Vectors& to) {
  std::copy_n(from, to.getLocalLength(), to.getDataNonConst(0).begin());
}

}  // namespace

IterativeSolver::IterativeSolver(const Teuchos::RCP<const base::CrsMatrix>& matrix,
                                 const Teuchos::RCP<base::MultiVector>& nearKernel, int components, double tolerance)
    : matrix_(matrix), tolerance_(tolerance), target_(firstTarget * tolerance) {
  Teuchos::RCP<base::Operator> multigrid;
  multigridLibrary()(matrix, nearKernel, components, multigrid);
  multigrid_ = multigrid;
}

IterativeSolver::~IterativeSolver() = default;

// Column by column: where some of a block have converged, MueLu of Trilinos 13.2 is given fewer than it has made room
// for, and fails; and blocks gain a quarter only, for their operators are multiplied by each column.
void IterativeSolver::solve(const base::Matrix& b, base::Matrix& x) const {
  Vectors left(matrix_->getDomainMap(), 1), right(matrix_->getRangeMap(), 1);
  for (int j = 0; j < b.numCols(); ++j) {
    copy(b[j], right);
    if (dot(right, right) == 0.0) {
      std::fill_n(x[j], x.numRows(), 0.0);
      continue;
    }
    copy(x[j], left);
    solveColumn(left, right);
    std::copy_n(left.getData(0).begin(), x.numRows(), x[j]);
  }
}

void IterativeSolver::solveColumn(base::MultiVector& left, const base::MultiVector& right) const {
  const Vectors distance = residualOf(*matrix_, left, right);
  if (!(dot(distance, distance) < dot(right, right))) left.putScalar(0.0);  // also where they are no numbers
  double error = 0.0;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const auto problem = Teuchos::rcp(new Belos::LinearProblem<double, Vectors, base::Operator>(
        matrix_, Teuchos::rcpFromRef(left), Teuchos::rcpFromRef(right)));
    problem->setLeftPrec(multigrid_);
    problem->setProblem();
    const auto parameters = Teuchos::parameterList();
    parameters->set("Maximum Iterations", maximumIterations);
    parameters->set("Convergence Tolerance", target_);
    parameters->set("Residual Scaling", "Norm of RHS");
    Belos::PseudoBlockCGSolMgr<double, Vectors, base::Operator> solver(problem, parameters);
    try {
      solver.solve();
    } catch (const std::logic_error& failure) {  // Belos', where A or the preconditioner is indefinite
      throw NotConverged(failure.what());
    }
    iterations_ += solver.getNumIters();
    error = energyError(left, right);
    if (error <= tolerance_ || solver.getNumIters() >= maximumIterations) break;
    target_ *= tighter;
  }
  if (!(error <= bearable * tolerance_)) {
    throw NotConverged("relative energy error " + base::toText(error) + " where " + base::toText(tolerance_) +
                       " is asked for");
  }
}

double IterativeSolver::energyError(const base::MultiVector& left, const base::MultiVector& right) const {
  const Vectors residual = residualOf(*matrix_, left, right);
  Vectors correction(matrix_->getDomainMap(), 1);
  multigrid_->apply(residual, correction);
  const double square = dot(residual, correction) / dot(right, left);
  return square >= 0.0 ? underestimate * std::sqrt(square) : HUGE_VAL;
}

base::Matrix IterativeSolver::residual(const base::Matrix& b, const base::Matrix& x) const {
  base::Matrix result(b.numRows(), b.numCols(), false);
  Vectors left(matrix_->getDomainMap(), 1), right(matrix_->getRangeMap(), 1);
  for (int j = 0; j < b.numCols(); ++j) {
    copy(x[j], left);
    copy(b[j], right);
    std::copy_n(residualOf(*matrix_, left, right).getData(0).begin(), b.numRows(), result[j]);
  }
  return result;
}

}  // namespace harmos::substructure
