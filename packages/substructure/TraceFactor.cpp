#include <harmos/substructure/TraceFactor.hpp>

#include <Teuchos_BLAS.hpp>

// BLAS, which Teuchos wraps but for this routine.
extern "C" void dtrsv_(const char* uplo, const char* transposed, const char* diagonal, const int* n, const double* a,
                       const int* stride, double* x, const int* increment);

namespace harmos::substructure {
namespace {

/// Solves with L, or with its transpose, in place.
void solveTriangular(const base::Matrix& lower, Teuchos::ETransp transposed, base::Matrix& y) {
  const int rows = lower.numRows();
  if (y.numCols() == 1) {
    // One column is bound by memory, and dtrsm reads L several times.
    const int stride = lower.stride();
    const int increment = 1;
    dtrsv_("L", transposed == Teuchos::TRANS ? "T" : "N", "N", &rows, lower.values(), &stride, y.values(), &increment);
    return;
  }
  const Teuchos::BLAS<int, double> blas;
  blas.TRSM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, transposed, Teuchos::NON_UNIT_DIAG, rows, y.numCols(), 1.0,
            lower.values(), lower.stride(), y.values(), y.stride());
}

}  // namespace

void TraceFactor::solve(const base::Matrix& b, base::Matrix& x) const {
  const int rows = lower.numRows();
  const int columns = b.numCols();
  base::Matrix y(rows, columns, false);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) y[j][row] = b[j][order[row]];
  }
  solveTriangular(lower, Teuchos::NO_TRANS, y);
  solveTriangular(lower, Teuchos::TRANS, y);
  if (x.numRows() != rows || x.numCols() != columns) x.shapeUninitialized(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) x[j][order[row]] = y[j][row];
  }
}

}  // namespace harmos::substructure
