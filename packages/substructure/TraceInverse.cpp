#include <harmos/substructure/detail/TraceInverse.hpp>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

/// (L L^T)^-1, the lower triangle.
base::Matrix inverseOf(const LowerTriangle& lower) {
  const int rows = lower.rows();
  base::Matrix inverse(rows, rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = j; i < rows; ++i) inverse(i, j) = lower(i, j);
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRI('L', rows, inverse.values(), inverse.stride(), &info);
  if (info != 0) throw base::Error("A trace is singular.");
  return inverse;
}

}  // namespace

TraceInverse::TraceInverse(const TraceFactor& factor)
    : order_(factor.order), exact_(factor.lower.rows()), rough_(factor.lower.rows()) {
  const base::Matrix inverse = inverseOf(factor.lower);
  for (int j = 0; j < rows(); ++j) {
    for (int i = j; i < rows(); ++i) {
      exact_.set(i, j, inverse(i, j));
      rough_.set(i, j, inverse(i, j));
    }
  }
}

template <class Triangle>
void TraceInverse::apply(const Triangle& triangle, const base::Matrix& b, base::Matrix& x) const {
  const int columns = b.numCols();
  base::Matrix ordered(rows(), columns, false), product;
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows(); ++row) ordered[j][row] = b[j][order_[row]];
  }
  triangle.multiply(ordered, product);
  if (x.numRows() != rows() || x.numCols() != columns) x.shapeUninitialized(rows(), columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows(); ++row) x[j][order_[row]] = product[j][row];
  }
}

void TraceInverse::solve(const base::Matrix& b, base::Matrix& x) const {
  apply(exact_, b, x);
}

void TraceInverse::solveRoughly(const base::Matrix& b, base::Matrix& x) const {
  apply(rough_, b, x);
}

}  // namespace harmos::substructure
