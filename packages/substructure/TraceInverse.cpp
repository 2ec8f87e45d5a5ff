#include <harmos/substructure/TraceInverse.hpp>

#include <algorithm>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

// BLAS, which Teuchos wraps but for this routine.
extern "C" void ssymv_(const char* uplo, const int* n, const float* alpha, const float* a, const int* stride,
                       const float* x, const int* incrementX, const float* beta, float* y, const int* incrementY);

namespace harmos::substructure {
namespace {

// Up to so many columns, products with a triangle, which read half of the matrix for each, are faster than one product.
constexpr int fewColumns = 2;

}  // namespace

TraceInverse::TraceInverse(const TraceFactor& factor) {
  const int rows = factor.lower.rows();
  base::Matrix inverse(rows, rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = j; i < rows; ++i) inverse(i, j) = factor.lower(i, j);
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRI('L', rows, inverse.values(), inverse.stride(), &info);
  if (info != 0) throw base::Error("A trace is singular.");
  inverse_.shapeUninitialized(rows, rows);
  rough_.shape(rows, rows);
  for (int j = 0; j < rows; ++j) {
    const int column = factor.order[j];
    for (int i = j; i < rows; ++i) {
      const int row = factor.order[i];
      inverse_(row, column) = inverse_(column, row) = inverse(i, j);
      rough_(row, column) = rough_(column, row) = static_cast<float>(inverse(i, j));
    }
  }
}

void TraceInverse::solve(const base::Matrix& b, base::Matrix& x) const {
  if (x.numRows() != b.numRows() || x.numCols() != b.numCols()) x.shapeUninitialized(b.numRows(), b.numCols());
  x.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, inverse_, b, 0.0);
}

void TraceInverse::solveRoughly(const base::Matrix& b, base::Matrix& x) const {
  const int rows = rough_.numRows();
  const int columns = b.numCols();
  if (x.numRows() != rows || x.numCols() != columns) x.shapeUninitialized(rows, columns);
  Rough right(rows, columns, false), left(rows, columns, false);
  for (int j = 0; j < columns; ++j) std::copy_n(b[j], rows, right[j]);
  if (columns <= fewColumns) {
    const int increment = 1;
    const float one = 1.0F, zero = 0.0F;
    for (int j = 0; j < columns; ++j)
      ssymv_("L", &rows, &one, rough_.values(), &rows, right[j], &increment, &zero, left[j], &increment);
  } else {
    left.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0F, rough_, right, 0.0F);
  }
  for (int j = 0; j < columns; ++j) std::copy_n(left[j], rows, x[j]);
}

}  // namespace harmos::substructure
