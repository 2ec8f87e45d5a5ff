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

SingleFactor TraceFactor::single() const {
  SingleFactor result;
  result.order = order;
  const int rows = lower.rows();
  // A panel is a supernode, whose rows are all from its first column on.
  for (int panel = 0; panel < lower.panels(); ++panel) {
    const int first = panel * LowerTriangle::width;
    result.firstColumn.push_back(first);
    result.firstRow.push_back(static_cast<int>(result.row.size()));
    result.firstValue.push_back(lower.offsetOf(panel));
    for (int row = first; row < rows; ++row) result.row.push_back(row);
  }
  result.firstColumn.push_back(rows);
  result.firstRow.push_back(static_cast<int>(result.row.size()));
  result.firstValue.push_back(lower.entries());
  result.value.assign(lower.values().begin(), lower.values().end());
  result.invertTriangles();
  return result;
}

}  // namespace harmos::substructure
