#include <harmos/substructure/CrsMatrix.hpp>

#include <algorithm>
#include <utility>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {

struct CrsRows::Views {
  using LocalMatrix = base::CrsMatrix::local_matrix_device_type;
  using Pointers = LocalMatrix::staticcrsgraph_type::row_map_type::non_const_type;
  using Columns = LocalMatrix::index_type;
  using Values = LocalMatrix::values_type;

  Pointers pointers;
  Columns columns;
  Values values;
};

CrsRows::CrsRows(const std::vector<std::size_t>& rowPointers) {
  if (rowPointers.empty() || rowPointers.front() != 0 || !std::is_sorted(rowPointers.begin(), rowPointers.end()))
    throw base::Error("A sparse matrix was given row pointers that do not rise from 0.");
  const std::size_t entries = rowPointers.back();
  // Kokkos zeroes new views; that would touch the memory twice.
  const auto bare = [](const char* label) { return Kokkos::ViewAllocateWithoutInitializing(label); };
  views_ =
      std::make_unique<Views>(Views{Views::Pointers(bare("row pointers"), rowPointers.size()),
                                    Views::Columns(bare("columns"), entries), Views::Values(bare("values"), entries)});
  std::copy(rowPointers.begin(), rowPointers.end(), views_->pointers.data());
}

CrsRows::~CrsRows() = default;
CrsRows::CrsRows(CrsRows&&) noexcept = default;
CrsRows& CrsRows::operator=(CrsRows&&) noexcept = default;

int* CrsRows::columns() {
  return views_->columns.data();
}

double* CrsRows::values() {
  return views_->values.data();
}

std::size_t CrsRows::rows() const {
  return views_->pointers.extent(0) - 1;
}

std::size_t CrsRows::entries() const {
  return views_->columns.extent(0);
}

Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(CrsRows rows) {
  const std::size_t count = rows.rows();
  const std::size_t* const pointers = rows.views_->pointers.data();
  const int* const columns = rows.columns();
  for (std::size_t row = 0; row < count; ++row) {
    for (std::size_t k = pointers[row]; k < pointers[row + 1]; ++k) {
      const bool ascending = k == pointers[row] || columns[k - 1] < columns[k];
      if (!ascending || columns[k] < 0 || static_cast<std::size_t>(columns[k]) >= count) {
        throw base::Error("Row " + std::to_string(row) + " of a sparse matrix of " + std::to_string(count) +
                          " rows has column " + std::to_string(columns[k]) +
                          ": columns must be ascending and counted from 0.");
      }
    }
  }
  const Teuchos::RCP<const Teuchos::Comm<int>> self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  using Map = base::CrsMatrix::map_type;
  const auto map = Teuchos::rcp(new Map(static_cast<Tpetra::global_size_t>(count), 0, self, Tpetra::LocallyReplicated));
  auto matrix =
      Teuchos::rcp(new base::CrsMatrix(map, map, rows.views_->pointers, rows.views_->columns, rows.views_->values));
  matrix->expertStaticFillComplete(map, map);
  return matrix;
}

Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(const std::vector<std::size_t>& rowPointers,
                                            const std::vector<int>& columns, const std::vector<double>& values) {
  if (rowPointers.empty() || rowPointers.back() != columns.size() || columns.size() != values.size()) {
    throw base::Error("A sparse matrix was given " + std::to_string(columns.size()) + " columns, " +
                      std::to_string(values.size()) +
                      " values and row pointers that do not run from 0 to that number.");
  }
  CrsRows rows(rowPointers);
  std::copy(columns.begin(), columns.end(), rows.columns());
  std::copy(values.begin(), values.end(), rows.values());
  return makeCrsMatrix(std::move(rows));
}

Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(std::vector<MatrixEntry> entries, int rows) {
  addUp(entries);
  std::vector<std::size_t> pointers(static_cast<std::size_t>(rows) + 1, 0);
  for (const MatrixEntry& entry : entries) ++pointers[static_cast<std::size_t>(entry.row) + 1];
  for (int row = 0; row < rows; ++row) pointers[row + 1] += pointers[row];
  CrsRows result(pointers);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    result.columns()[k] = entries[k].column;
    result.values()[k] = entries[k].value;
  }
  return makeCrsMatrix(std::move(result));
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
