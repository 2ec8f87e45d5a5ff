#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Tpetra.hpp>
#include <harmos/substructure/SingleFactor.hpp>
#include <harmos/substructure/SolverOptions.hpp>
#include <harmos/substructure/TraceFactor.hpp>

namespace Amesos2 {
template <class Matrix, class Vector>
class Solver;
}

namespace harmos::substructure {

/// A direct solver behind Amesos2's interface, of Harmos or of Trilinos.
using DirectSolver = Amesos2::Solver<base::CrsMatrix, base::MultiVector>;

/// The solver that the options name, nothing factored yet; it shares the matrix. Throws as requireSolver().
/// `trace`: the rows, ascending, that solves with traceFactor() will be about; empty: none.
Teuchos::RCP<DirectSolver> makeSolver(const SolverOptions& options, const Teuchos::RCP<const base::CrsMatrix>& matrix,
                                      const std::vector<int>& trace);

/// What a factored solver made with a trace offers for it, a copy that the caller owns: null when its sparse factor is
/// cheaper, or when it is not CHOLMOD.
std::unique_ptr<TraceFactor> traceFactor(const DirectSolver& solver);

/// The factor of a factored solver in single precision, a copy that the caller owns: null when it is not a supernodal
/// one of CHOLMOD.
std::unique_ptr<SingleFactor> singleFactor(const DirectSolver& solver);

}  // namespace harmos::substructure
