#pragma once

#include <harmos/substructure/SolverOptions.hpp>

namespace harmos::latin {

/// A solve of a whole body among many at once over one among those of a few load steps.
inline constexpr double shareOfSolveAmongMany = 1.0 / 3.0;

/// Whether reactions of a body with an inverted trace of so many rows are taken from dense matrices that `solves`
/// solves of the whole body prepare: these take no longer than those that are expected without, and the matrices no
/// more entries than two inverses of the trace.
inline bool isStencilWorthwhile(const substructure::SolverOptions& options, double solves, double rows) {
  return options.invertTrace && shareOfSolveAmongMany * solves <= options.wholeSolves && solves <= 2.0 * rows;
}

}  // namespace harmos::latin
