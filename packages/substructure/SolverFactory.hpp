#pragma once

#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace Amesos2 {
template <class Matrix, class Vector>
class Solver;
}

namespace harmos::substructure {

using DirectSolver = Amesos2::Solver<base::CrsMatrix, base::MultiVector>;

/// The solver that the options name, nothing factored yet. Throws base::Error, listing availableSolvers(), when there
/// is none of this name.
Teuchos::RCP<DirectSolver> makeSolver(const SolverOptions& options, const Teuchos::RCP<const base::CrsMatrix>& matrix);

}  // namespace harmos::substructure
