#include <harmos/substructure/TraceFactor.hpp>

#include <Teuchos_BLAS.hpp>

namespace harmos::substructure {

void TraceFactor::solve(const base::Matrix& b, base::Matrix& x) const {
  const Teuchos::BLAS<int, double> blas;
  const int rows = lower.numRows();
  const int columns = b.numCols();
  base::Matrix y(rows, columns, false);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) y[j][row] = b[j][order[static_cast<std::size_t>(row)]];
  }
  for (const Teuchos::ETransp transposed : {Teuchos::NO_TRANS, Teuchos::TRANS}) {
    blas.TRSM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, transposed, Teuchos::NON_UNIT_DIAG, rows, columns, 1.0,
              lower.values(), lower.stride(), y.values(), y.stride());
  }
  if (x.numRows() != rows || x.numCols() != columns) x.shapeUninitialized(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) x[j][order[static_cast<std::size_t>(row)]] = y[j][row];
  }
}

}  // namespace harmos::substructure
