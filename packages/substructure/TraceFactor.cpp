#include <harmos/substructure/TraceFactor.hpp>

namespace harmos::substructure {

void TraceFactor::solve(const base::Matrix& b, base::Matrix& x) const {
  const int rows = lower.rows();
  const int columns = b.numCols();
  base::Matrix y(rows, columns, false);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) y[j][row] = b[j][order[row]];
  }
  lower.solve(y);
  lower.solveTransposed(y);
  if (x.numRows() != rows || x.numCols() != columns) x.shapeUninitialized(rows, columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) x[j][order[row]] = y[j][row];
  }
}

}  // namespace harmos::substructure
