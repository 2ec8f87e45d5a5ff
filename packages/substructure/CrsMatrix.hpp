#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <harmos/base/Tpetra.hpp>

namespace harmos::substructure {

/// A sparse matrix on MPI_COMM_SELF from compressed rows; the arrays are copied.
///
/// rowPointers has one entry per row and a last one equal to the number of entries; the columns of a row are ascending
/// and counted from 0. Square. Throws base::Error when the arrays do not fit together.
Teuchos::RCP<base::CrsMatrix> makeCrsMatrix(const std::vector<std::size_t>& rowPointers,
                                            const std::vector<int>& columns, const std::vector<double>& values);

/// The compressed rows of a matrix, owned by the matrix.
struct CrsView {
  int rows = 0;
  const std::size_t* rowPointers = nullptr;
  const int* columns = nullptr;
  const double* values = nullptr;
};

/// Throws base::Error unless the matrix is square, complete, on one process, its columns counted as its rows and
/// ascending in each row: what assembled stiffness matrices are. `name` is the part's, for the message.
CrsView viewOf(const base::CrsMatrix& matrix, const std::string& name);

/// Mean over the components of the diagonal entries of each node [force/length]; dofs are node by node.
std::vector<double> nodalStiffnessDiagonal(const base::CrsMatrix& stiffness, int dimension);

}  // namespace harmos::substructure
