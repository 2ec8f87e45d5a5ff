#pragma once

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::assembly {

/// Whether an assembly is what Assembly, Interface and substructure::Substructure ask for: lengths of all arrays,
/// numbers of bodies, nodes and pairs in their ranges, finite numbers, rows of trace operators with the sum 1, frames
/// of unit vectors at right angles, positive areas, ascending times, laws where they can be, and on the owners square
/// symmetric matrices of the right size.
///
/// Collective. Throws one base::Error (input) on every rank that lists what is wrong, by body, interface and pair; also
/// when the ranks were given different assemblies. Looks at every number once; whether matrices are definite is found
/// when they are factored. Returns the assembly.
const Assembly& demandValid(const Assembly& assembly, const Teuchos::Comm<int>& comm);

}  // namespace harmos::assembly
