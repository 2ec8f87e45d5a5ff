#pragma once

#include <harmos/base/Tpetra.hpp>

namespace harmos::substructure {

/// Name of the function in the library multigrid.so, which has this type: makes a preconditioner, an approximation of
/// A^-1 [length/force], symmetric and positive definite, by smoothed aggregation with Chebyshev smoothers (MueLu).
/// matrix: A, symmetric and positive definite, shared. nearKernel: columns x with A x small beside |A| |x|, those of a
/// body its rigid motions [length]. components: unknowns of a node.
/// Source: Vanek, Mandel, Brezina, Computing 56 (1996), doi:10.1007/BF02238511.
inline constexpr const char* multigridSymbol = "harmosMakeMultigrid";
/// Type of that function.
using MakeMultigrid = void(const Teuchos::RCP<const base::CrsMatrix>& matrix,
                           const Teuchos::RCP<base::MultiVector>& nearKernel, int components,
                           Teuchos::RCP<base::Operator>& multigrid);

/// That function, of the library that is loaded when it is first asked for: the one that the environment variable
/// HARMOS_MULTIGRID names, else multigrid.so in the folder harmos of the libraries beside the program. Throws
/// base::Error (input) that says what is to be installed when there is none.
MakeMultigrid& multigridLibrary();
/// Whether there is one, which is not loaded for that.
bool hasMultigrid();

}  // namespace harmos::substructure
