#include <harmos/substructure/DirectFactor.hpp>

#include <Amesos2_Solver.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_MultiVector.hpp>

#include <harmos/substructure/CrsMatrix.hpp>
#include <harmos/substructure/detail/MultiVectorView.hpp>
#include <harmos/substructure/detail/TraceInverse.hpp>

namespace harmos::substructure {
namespace {

/// So many rows without entries.
Teuchos::RCP<const base::CrsMatrix> emptyMatrix(std::size_t rows) {
  return makeCrsMatrix(std::vector<std::size_t>(rows + 1, 0), {}, {});
}

}  // namespace

DirectFactor::DirectFactor(const Teuchos::RCP<const base::CrsMatrix>& matrix, const SolverOptions& options,
                           const std::vector<int>& trace)
    : matrix_(matrix), solver_(makeSolver(options, matrix, trace)) {
  solver_->numericFactorization();
  trace_ = traceFactor(*solver_);
  if (trace_ && trace_->isToBeInverted) {
    inverse_ = std::make_unique<TraceInverse>(*trace_);
    trace_.reset();
  }
  if (solver_->name() != "Cholmod" && solver_->name() != "Tacho") return;
  matrix_ = emptyMatrix(matrix->getGlobalNumRows());
  solver_->setA(matrix_, Amesos2::NUMFACT);
}

DirectFactor::~DirectFactor() = default;
DirectFactor::DirectFactor(DirectFactor&&) noexcept = default;
DirectFactor& DirectFactor::operator=(DirectFactor&&) noexcept = default;

void DirectFactor::solve(const base::Matrix& b, base::Matrix& x, bool roughly) const {
  if (roughly && single_) {
    single_->solve(b, x);
    return;
  }
  const base::MultiVector right = viewOf(b, matrix_->getRowMap());
  base::MultiVector left = viewOf(x, matrix_->getRowMap());
  solver_->solve(&left, &right);
}

void DirectFactor::solveTrace(const base::Matrix& b, base::Matrix& x, bool roughly) const {
  if (!inverse_) {
    trace_->solve(b, x);
  } else if (roughly) {
    inverse_->solveRoughly(b, x);
  } else {
    inverse_->solve(b, x);
  }
}

void DirectFactor::prepareSingle(const std::vector<int>& trace) {
  if (!solvesTrace()) single_ = singleFactor(*solver_);
  if (single_) single_->setTrace(trace);
}

std::size_t DirectFactor::nonzeros() const {
  return solver_->getStatus().getNnzLU();
}

}  // namespace harmos::substructure
