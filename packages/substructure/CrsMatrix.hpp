#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/MatrixEntry.hpp>

namespace harmos::substructure {

/// Compressed rows that are filled where the matrix will have them, so that large ones are not copied.
class CrsRows {
 public:
  /// `rowPointers`: where each row begins among the entries, and their number. Columns and values are to be set, all of
  /// them. Throws base::Error unless the pointers begin with 0 and do not fall. Kokkos must be running.
  explicit CrsRows(const std::vector<std::size_t>& rowPointers);
  ~CrsRows();
  CrsRows(CrsRows&&) noexcept;             ///< leaves rows that may only be assigned to
  CrsRows& operator=(CrsRows&&) noexcept;  ///< likewise

  int* columns();               ///< from 0, ascending in each row
  double* values();             ///< in the unit of the matrix
  std::size_t rows() const;     ///< also columns
  std::size_t entries() const;  ///< of all rows

 private:
  struct Views;
  std::unique_ptr<Views> views_;

  friend Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(CrsRows rows);
};

/// A sparse matrix on MPI_COMM_SELF of rows that are set; it takes them over. Square. Throws base::Error when columns
/// are not ascending in a row, or beyond the rows. Not collective; MPI must be running.
Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(CrsRows rows);
/// The same of arrays, which are copied. Throws base::Error also when they do not fit together.
Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(const std::vector<std::size_t>& rowPointers,
                                            const std::vector<int>& columns, const std::vector<double>& values);

/// The same of entries in any order, which add up where they are repeated.
Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(std::vector<MatrixEntry> entries, int rows);

/// The compressed rows of a matrix, owned by the matrix and valid as long as it lives and keeps its structure.
struct CrsView {
  int rows = 0;                              ///< also columns
  const std::size_t* rowPointers = nullptr;  ///< rows + 1: where each row begins in the other two
  const int* columns = nullptr;              ///< from 0, ascending in each row
  const double* values = nullptr;            ///< in the unit of the matrix

  /// Where an entry stands in `columns` and `values`, or rowPointers[rows] when it is not stored.
  std::size_t positionOf(int row, int column) const {
    const int* begin = columns + rowPointers[row];
    const int* end = columns + rowPointers[row + 1];
    const int* found = std::lower_bound(begin, end, column);
    return found != end && *found == column ? static_cast<std::size_t>(found - columns) : rowPointers[rows];
  }
};

/// Looks into a matrix, copying nothing. Throws base::Error unless the matrix is square, complete, on one process, its
/// columns counted as its rows and ascending in each row: what assembled stiffness matrices are. `name` is the part's,
/// for the message.
CrsView viewOf(const base::CrsMatrix& matrix, const std::string& name);

/// Mean over the components of the diagonal entries of each node [force/length]; dofs are node by node, `dimension` of
/// them each, which must divide the rows. An entry that is not stored counts as 0. Throws base::Error as viewOf().
std::vector<double> nodalStiffnessDiagonal(const base::CrsMatrix& stiffness, int dimension);

}  // namespace harmos::substructure
