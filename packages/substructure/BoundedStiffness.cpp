#include <harmos/substructure/detail/BoundedStiffness.hpp>

#include <algorithm>
#include <set>
#include <vector>

#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::substructure {
namespace {

using Entries = std::vector<MatrixEntry>;

/// Copy of the matrix with explicit zeros where the boundary term has entries that the matrix does not store.
Teuchos::RCP<base::CrsMatrix> withEntries(const CrsView& matrix, const Entries& missing) {
  std::vector<std::size_t> pointers{0};
  std::vector<int> columns;
  std::vector<double> values;
  auto next = missing.begin();
  for (int row = 0; row < matrix.rows; ++row) {
    std::size_t k = matrix.rowPointers[row];
    const std::size_t end = matrix.rowPointers[row + 1];
    while (k < end || (next != missing.end() && next->row == row)) {
      const bool added = next != missing.end() && next->row == row && (k == end || next->column < matrix.columns[k]);
      columns.push_back(added ? next->column : matrix.columns[k]);
      values.push_back(added ? 0.0 : matrix.values[k]);
      if (added) {
        ++next;
      } else {
        ++k;
      }
    }
    pointers.push_back(columns.size());
  }
  return makeCrsMatrix(pointers, columns, values);
}

void add(Entries& entries, int rows, const std::string& part, int row, int column, double value) {
  if (row < 0 || column < 0 || row >= rows || column >= rows) {
    throw base::Error("The boundary term of part \"" + part + "\" has an entry at row " + std::to_string(row) +
                      ", column " + std::to_string(column) + "; its stiffness matrix has " + std::to_string(rows) +
                      " rows.");
  }
  entries.push_back({row, column, value});
}

/// k h + s, in any order.
Entries addedEntries(int rows, const BoundaryTerm& boundary, const std::string& part) {
  Entries entries;
  const int dimension = boundary.dimension;
  const auto add = [&](int row, int column, double value) {
    substructure::add(entries, rows, part, row, column, value);
  };
  for (std::size_t row = 0; row < boundary.diagonal.size(); ++row) {
    if (boundary.diagonal[row] != 0.0) add(static_cast<int>(row), static_cast<int>(row), boundary.diagonal[row]);
  }
  for (const MatrixEntry& entry : boundary.entries) {
    for (int c = 0; c < dimension; ++c) add(entry.row * dimension + c, entry.column * dimension + c, entry.value);
  }
  for (const BoundaryTerm::NodeTensor& spring : boundary.springs) {
    for (int i = 0; i < dimension; ++i) {
      for (int j = 0; j < dimension; ++j) {
        add(spring.node * dimension + i, spring.node * dimension + j, spring.value[i][j]);
      }
    }
  }
  return entries;
}

/// What the boundary adds, by row and column, each place once; entries that a projection fills are there with 0.
Entries entriesOf(const CrsView& matrix, const BoundaryTerm& boundary, const std::string& part) {
  Entries entries = addedEntries(matrix.rows, boundary, part);
  const int dimension = boundary.dimension;
  const auto add = [&](int row, int column, double value) {
    substructure::add(entries, matrix.rows, part, row, column, value);
  };
  for (const BoundaryTerm::NodeTensor& held : boundary.free) {
    std::set<int> neighbours{held.node};
    for (int c = 0; c < dimension; ++c) {
      const int row = held.node * dimension + c;
      if (row < 0 || row >= matrix.rows) add(row, row, 0.0);
      for (std::size_t k = matrix.rowPointers[row]; k < matrix.rowPointers[row + 1]; ++k) {
        neighbours.insert(matrix.columns[k] / dimension);
      }
    }
    for (const int neighbour : neighbours) {
      for (int i = 0; i < dimension; ++i) {
        for (int j = 0; j < dimension; ++j) {
          const int row = held.node * dimension + i, column = neighbour * dimension + j;
          if (matrix.positionOf(row, column) != matrix.rowPointers[matrix.rows]) continue;
          add(row, column, 0.0);
          if (neighbour != held.node) add(column, row, 0.0);
        }
      }
    }
  }
  addUp(entries);
  return entries;
}

}  // namespace

Teuchos::RCP<base::CrsMatrix> sumOf(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary,
                                    const std::string& part) {
  const CrsView view = viewOf(stiffness, part);
  const auto rows = static_cast<std::size_t>(view.rows);
  if (!boundary.diagonal.empty() && boundary.diagonal.size() != rows) {
    throw base::Error("The boundary term of part \"" + part + "\" has " + std::to_string(boundary.diagonal.size()) +
                      " diagonal entries; its stiffness matrix has " + std::to_string(rows) + " rows.");
  }
  const Entries added = entriesOf(view, boundary, part);
  Entries missing;
  for (const MatrixEntry& entry : added) {
    if (view.positionOf(entry.row, entry.column) == view.rowPointers[view.rows]) missing.push_back(entry);
  }
  // Once more, as held nodes may have neighbours by them.
  if (!missing.empty()) return sumOf(*withEntries(view, missing), boundary, part);
  using Values = base::CrsMatrix::local_matrix_device_type::values_type;
  Values values(Kokkos::ViewAllocateWithoutInitializing("values"), view.rowPointers[view.rows]);
  std::copy(view.values, view.values + values.extent(0), values.data());
  for (const MatrixEntry& entry : added) values(view.positionOf(entry.row, entry.column)) += entry.value;
  auto sum = Teuchos::rcp(new base::CrsMatrix(stiffness.getCrsGraph(), values));
  sum->fillComplete(stiffness.getDomainMap(), stiffness.getRangeMap());
  return sum;
}

Teuchos::RCP<base::CrsMatrix> addedMatrix(const BoundaryTerm& boundary, int rows) {
  return makeCrsMatrix(addedEntries(rows, boundary, "boundary term"), rows);
}

Teuchos::RCP<base::CrsMatrix> heldMatrix(const BoundaryTerm& boundary, int rows) {
  Entries entries;
  for (const BoundaryTerm::NodeTensor& held : boundary.free) {
    const int first = held.node * boundary.dimension;
    for (int i = 0; i < boundary.dimension; ++i) {
      for (int j = 0; j < boundary.dimension; ++j) {
        entries.push_back({first + i, first + j, (i == j ? 1.0 : 0.0) - held.value[i][j]});
      }
    }
  }
  return makeCrsMatrix(entries, rows);
}

void project(base::CrsMatrix& matrix, const BoundaryTerm& boundary) {
  if (boundary.free.empty()) return;
  const CrsView view = viewOf(matrix, "boundary term");
  const auto local = matrix.getLocalMatrixHost();
  const int dimension = boundary.dimension;
  std::map<int, double> size;
  for (const BoundaryTerm::NodeTensor& held : boundary.free) {
    for (int c = 0; c < dimension; ++c) {
      const int row = held.node * dimension + c;
      size[held.node] += local.values(view.positionOf(row, row)) / dimension;
    }
  }
  // Rows, then columns, of one held node after the other.
  for (const BoundaryTerm::NodeTensor& held : boundary.free) {
    const int first = held.node * dimension;
    const auto turn = [&](bool isRow, int other) {
      base::Vector3 old{};
      const auto at = [&](int c) {
        return isRow ? view.positionOf(first + c, other) : view.positionOf(other, first + c);
      };
      for (int c = 0; c < dimension; ++c) old[c] = local.values(at(c));
      const base::Vector3 now = base::product(held.value, old);
      for (int c = 0; c < dimension; ++c) local.values(at(c)) = now[c];
    };
    const std::size_t begin = view.rowPointers[first], end = view.rowPointers[first + 1];
    for (std::size_t k = begin; k < end; ++k) turn(true, view.columns[k]);
    for (std::size_t k = begin; k < end; ++k) turn(false, view.columns[k]);
    for (int i = 0; i < dimension; ++i) {
      for (int j = 0; j < dimension; ++j) {
        const double unit = i == j ? 1.0 : 0.0;
        local.values(view.positionOf(first + i, first + j)) += size[held.node] * (unit - held.value[i][j]);
      }
    }
  }
}

}  // namespace harmos::substructure
