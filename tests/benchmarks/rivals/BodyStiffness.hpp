#pragma once

#include <harmos/substructure/Substructure.hpp>

#include "SparseMatrix.hpp"

namespace harmos::benchmarks {

/// The stiffness matrix of a body in space, its own copy also where it shares that of an equal one; then columns are
/// not ascending. `bodies` are those of an assembly. Throws base::Error when rows do not come in whole nodes.
SparseMatrix stiffnessOf(const std::vector<substructure::Substructure>& bodies, std::size_t body);

}  // namespace harmos::benchmarks
