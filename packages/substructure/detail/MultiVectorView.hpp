#pragma once

// Private to this package; heavy.
#include <cstddef>

#include <Tpetra_MultiVector.hpp>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>

namespace harmos::substructure {

/// The matrix as a block of vectors, not copied. Amesos2 wants the right-hand side const but has no const view.
inline base::MultiVector viewOf(const base::Matrix& matrix,
                                const Teuchos::RCP<const base::MultiVector::map_type>& map) {
  using Vectors = base::MultiVector::dual_view_type;
  const Vectors::t_dev view(matrix.values(), static_cast<std::size_t>(matrix.numRows()),
                            static_cast<std::size_t>(matrix.numCols()));
  return {map, Vectors(view, view)};
}

}  // namespace harmos::substructure
