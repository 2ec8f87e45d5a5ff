#include <harmos/substructure/CrsMatrix.hpp>

#include <algorithm>
#include <cstring>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

/// Kokkos zeroes new views; that would touch the memory twice.
template <class View, class T>
View copyOf(const std::vector<T>& source, const char* label) {
  View view(Kokkos::ViewAllocateWithoutInitializing(label), source.size());
  if (!source.empty()) std::memcpy(view.data(), source.data(), source.size() * sizeof(T));
  return view;
}

}  // namespace

Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(const std::vector<std::size_t>& rowPointers,
                                            const std::vector<int>& columns, const std::vector<double>& values) {
  using Map = base::CrsMatrix::map_type;
  using LocalMatrix = base::CrsMatrix::local_matrix_device_type;
  using RowMap = LocalMatrix::staticcrsgraph_type::row_map_type::non_const_type;
  using Columns = LocalMatrix::index_type;
  using Values = LocalMatrix::values_type;
  if (rowPointers.empty() || rowPointers.front() != 0 || rowPointers.back() != columns.size() ||
      columns.size() != values.size()) {
    throw base::Error("A sparse matrix was given " + std::to_string(columns.size()) + " columns, " +
                      std::to_string(values.size()) +
                      " values and row pointers that do not run from 0 to that number.");
  }
  const std::size_t rows = rowPointers.size() - 1;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t k = rowPointers[row]; k < rowPointers[row + 1]; ++k) {
      const bool ascending = k == rowPointers[row] || columns[k - 1] < columns[k];
      if (!ascending || columns[k] < 0 || static_cast<std::size_t>(columns[k]) >= rows) {
        throw base::Error("Row " + std::to_string(row) + " of a sparse matrix of " + std::to_string(rows) +
                          " rows has column " + std::to_string(columns[k]) +
                          ": columns must be ascending and counted from 0.");
      }
    }
  }
  const Teuchos::RCP<const Teuchos::Comm<int>> self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(rows), 0, self, Tpetra::LocallyReplicated));
  auto matrix =
      Teuchos::rcp(new base::CrsMatrix(map, map, copyOf<RowMap>(rowPointers, "row pointers"),
                                       copyOf<Columns>(columns, "columns"), copyOf<Values>(values, "values")));
  matrix->expertStaticFillComplete(map, map);
  return matrix;
}

void addUp(std::vector<MatrixEntry>& entries) {
  const auto isBefore = [](const MatrixEntry& a, const MatrixEntry& b) {
    return a.row < b.row || (a.row == b.row && a.column < b.column);
  };
  std::stable_sort(entries.begin(), entries.end(), isBefore);
  std::size_t count = 0;
  for (const MatrixEntry& entry : entries) {
    if (count > 0 && !isBefore(entries[count - 1], entry)) {
      entries[count - 1].value += entry.value;
    } else {
      entries[count++] = entry;
    }
  }
  entries.resize(count);
}

Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(std::vector<MatrixEntry> entries, int rows) {
  addUp(entries);
  std::vector<std::size_t> pointers(static_cast<std::size_t>(rows) + 1, 0);
  std::vector<int> columns;
  std::vector<double> values;
  for (const MatrixEntry& entry : entries) {
    ++pointers[static_cast<std::size_t>(entry.row) + 1];
    columns.push_back(entry.column);
    values.push_back(entry.value);
  }
  for (int row = 0; row < rows; ++row) pointers[row + 1] += pointers[row];
  return makeCrsMatrix(pointers, columns, values);
}

CrsView viewOf(const base::CrsMatrix& matrix, const std::string& name) {
  const auto fail = [&name](const std::string& reason) {
    throw base::Error("The matrix of part \"" + name + "\" " + reason +
                      " Build it on MPI_COMM_SELF, for example with harmos::substructure::makeCrsMatrix.");
  };
  if (!matrix.isFillComplete()) fail("is not complete: fillComplete() was not called.");
  const auto map = matrix.getRowMap();
  if (map->getComm()->getSize() != 1) fail("is distributed over several processes.");
  if (!matrix.getDomainMap()->isSameAs(*map) || !matrix.getRangeMap()->isSameAs(*map)) fail("is not square.");
  if (!matrix.getColMap()->isSameAs(*map)) fail("numbers its columns otherwise than its rows, or has empty columns.");
  if (!matrix.getCrsGraph()->isSorted()) fail("has columns that are not ascending.");
  const auto local = matrix.getLocalMatrixHost();
  return {static_cast<int>(local.numRows()), local.graph.row_map.data(), local.graph.entries.data(),
          local.values.data()};
}

std::vector<double> nodalStiffnessDiagonal(const base::CrsMatrix& stiffness, int dimension) {
  const CrsView matrix = viewOf(stiffness, "stiffness");
  std::vector<double> mean(matrix.rows / dimension, 0.0);
  for (int row = 0; row < matrix.rows; ++row) {
    const int* begin = matrix.columns + matrix.rowPointers[row];
    const int* end = matrix.columns + matrix.rowPointers[row + 1];
    const int* found = std::lower_bound(begin, end, row);
    if (found != end && *found == row) mean[row / dimension] += matrix.values[found - matrix.columns];
  }
  for (double& value : mean) value /= dimension;
  return mean;
}

}  // namespace harmos::substructure
