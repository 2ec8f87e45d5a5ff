#pragma once

#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::substructure {

/// K + k h + s, not projected; shares the structure of K where that has all entries needed. `part`: for messages.
/// Throws base::Error when the term does not fit to the matrix.
Teuchos::RCP<base::CrsMatrix> sumOf(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary,
                                    const std::string& part);

/// k h + s, and 1 - P, of so many rows.
Teuchos::RCP<base::CrsMatrix> addedMatrix(const BoundaryTerm& boundary, int rows);
Teuchos::RCP<base::CrsMatrix> heldMatrix(const BoundaryTerm& boundary, int rows);

/// Makes P A P + d (1 - P) of A, which has the entries of all components of the nodes that are held, as sumOf() gives
/// it; d is the mean diagonal of the node.
void project(base::CrsMatrix& matrix, const BoundaryTerm& boundary);

}  // namespace harmos::substructure
