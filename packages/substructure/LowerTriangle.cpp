#include <harmos/substructure/LowerTriangle.hpp>

#include <algorithm>

#include <Teuchos_BLAS.hpp>

// BLAS, which Teuchos wraps but for this routine.
extern "C" void dtrsv_(const char* uplo, const char* transposed, const char* diagonal, const int* n, const double* a,
                       const int* stride, double* x, const int* increment);

namespace harmos::substructure {

LowerTriangle::LowerTriangle(int rows) : rows_(rows), values_(offsetOf(panels()), 0.0) {}

int LowerTriangle::columnsOf(int panel) const {
  return std::min(width, rows_ - panel * width);
}

std::size_t LowerTriangle::offsetOf(int panel) const {
  // Those before the last one are full.
  const auto full = static_cast<std::size_t>(std::min(panel, rows_ / width));
  const auto w = static_cast<std::size_t>(width), n = static_cast<std::size_t>(rows_);
  const std::size_t before = w * (full * n - w * (full * (full - (full > 0 ? 1 : 0)) / 2));
  const std::size_t rest = static_cast<std::size_t>(panel) > full ? n - full * w : 0;
  return before + rest * rest;
}

std::size_t LowerTriangle::at(int row, int column) const {
  const int panel = column / width, first = panel * width;
  return offsetOf(panel) + static_cast<std::size_t>(column - first) * static_cast<std::size_t>(rows_ - first) +
         static_cast<std::size_t>(row - first);
}

void LowerTriangle::solveDiagonal(int panel, bool isTransposed, base::Matrix& y) const {
  const int first = panel * width, columns = columnsOf(panel), stride = rows_ - first;
  const double* values = values_.data() + offsetOf(panel);
  if (y.numCols() == 1) {
    // One column is bound by memory, and dtrsm reads L several times.
    const int increment = 1;
    dtrsv_("L", isTransposed ? "T" : "N", "N", &columns, values, &stride, y.values() + first, &increment);
    return;
  }
  const Teuchos::BLAS<int, double> blas;
  blas.TRSM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, isTransposed ? Teuchos::TRANS : Teuchos::NO_TRANS,
            Teuchos::NON_UNIT_DIAG, columns, y.numCols(), 1.0, values, stride, y.values() + first, y.stride());
}

void LowerTriangle::solve(base::Matrix& y) const {
  const Teuchos::BLAS<int, double> blas;
  for (int panel = 0; panel < panels(); ++panel) {
    solveDiagonal(panel, false, y);
    const int first = panel * width, columns = columnsOf(panel), stride = rows_ - first, below = stride - columns;
    if (below == 0) continue;
    const double* values = values_.data() + offsetOf(panel) + columns;
    double* from = y.values() + first;
    if (y.numCols() == 1) {
      blas.GEMV(Teuchos::NO_TRANS, below, columns, -1.0, values, stride, from, 1, 1.0, from + columns, 1);
    } else {
      blas.GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, below, y.numCols(), columns, -1.0, values, stride, from,
                y.stride(), 1.0, from + columns, y.stride());
    }
  }
}

void LowerTriangle::solveTransposed(base::Matrix& y) const {
  const Teuchos::BLAS<int, double> blas;
  for (int panel = panels() - 1; panel >= 0; --panel) {
    const int first = panel * width, columns = columnsOf(panel), stride = rows_ - first, below = stride - columns;
    const double* values = values_.data() + offsetOf(panel) + columns;
    double* to = y.values() + first;
    if (below > 0 && y.numCols() == 1) {
      blas.GEMV(Teuchos::TRANS, below, columns, -1.0, values, stride, to + columns, 1, 1.0, to, 1);
    } else if (below > 0) {
      blas.GEMM(Teuchos::TRANS, Teuchos::NO_TRANS, columns, y.numCols(), below, -1.0, values, stride, to + columns,
                y.stride(), 1.0, to, y.stride());
    }
    solveDiagonal(panel, true, y);
  }
}

}  // namespace harmos::substructure
