#pragma once

#include <vector>

#include <harmos/base/Tpetra.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
#include <harmos/substructure/NestedDissection.hpp>
#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::substructure {

/// What the factors of a SubstructureSolver take, from the structure of its operator, in a small part of the time of
/// factoring it. Arguments as those of its constructor; Throws base::Error as that,
/// and when METIS fails.
FactorSize predictFactor(const base::CrsMatrix& stiffness, const BoundaryTerm& boundary,
                         const std::vector<int>& trace = {}, const std::vector<base::Vector3>& nodes = {},
                         const SolverOptions& options = SolverOptions());

}  // namespace harmos::substructure
