#include <harmos/substructure/TraceInverse.hpp>

#include <algorithm>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

// BLAS, which Teuchos wraps but for this routine.
extern "C" void ssymv_(const char* uplo, const int* n, const float* alpha, const float* a, const int* stride,
                       const float* x, const int* incrementX, const float* beta, float* y, const int* incrementY);

namespace harmos::substructure {

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
      rough_(std::max(row, column), std::min(row, column)) = static_cast<float>(inverse(i, j));
    }
  }
}

void TraceInverse::solve(const base::Matrix& b, base::Matrix& x) const {
  if (x.numRows() != b.numRows() || x.numCols() != b.numCols()) x.shapeUninitialized(b.numRows(), b.numCols());
  x.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, 1.0, inverse_, b, 0.0);
}

void TraceInverse::solveRoughly(const base::Matrix& b, base::Matrix& x) const {
  const int rows = rough_.numRows();
  const int stride = rough_.stride();
  const int increment = 1;
  const float one = 1.0f;
  const float zero = 0.0f;
  if (x.numRows() != rows || x.numCols() != b.numCols()) x.shapeUninitialized(rows, b.numCols());
  std::vector<float> right(rows), left(right.size());
  for (int j = 0; j < b.numCols(); ++j) {
    std::copy_n(b[j], rows, right.begin());
    ssymv_("L", &rows, &one, rough_.values(), &stride, right.data(), &increment, &zero, left.data(), &increment);
    std::copy_n(left.begin(), rows, x[j]);
  }
}

}  // namespace harmos::substructure
