#include <harmos/substructure/TraceInverse.hpp>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

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
  exact_ = SymmetricTriangle<double>(rows);
  rough_ = SymmetricTriangle<float>(rows);
  for (int j = 0; j < rows; ++j) {
    const int column = factor.order[j];
    for (int i = j; i < rows; ++i) {
      const int row = factor.order[i];
      exact_.set(row, column, inverse(i, j));
      rough_.set(row, column, inverse(i, j));
    }
  }
}

}  // namespace harmos::substructure
