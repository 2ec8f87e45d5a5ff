#pragma once

#include <vector>

#include <harmos/latin/AdjointProblem.hpp>
#include <harmos/recovery/DualWeightedResidual.hpp>
#include <harmos/scene/detail/PartPieces.hpp>

namespace harmos::scene {

/// The displacements of a run at some load steps, and the adjoints that weigh their errors.
struct AdjointFields {
  /// A column: per body its displacements; empty: of bodies of other ranks.
  using Column = std::vector<std::vector<double>>;

  std::vector<int> steps;                        ///< of the solutions, from 0: the one asked for first
  std::vector<Column> fields;                    ///< the solutions, then the adjoints
  std::vector<recovery::AdjointField> adjoints;  ///< those with the number of each response first, in its order
  std::vector<bool> isHidden;                    ///< per response: its adjoint did not converge
};

/// The adjoints of responses at a load step.
///
/// History is taken as given but for the jumps that laws keep since earlier load steps (latin::KeptJump): these depend
/// on the mesh as the solution did then. With q such a jump, the change of J is that at `step` plus dJ/dq times that of
/// q, so that every load step whose jumps are kept is a solution of its own, with one more adjoint for each response
/// that depends on them. Without that, a bolt tightened by force would seem to lose its force on a finer mesh, as if
/// its overlap had been given. `parts`: all (partPieces()). Collective; ends the validity of the state.
AdjointFields adjointFields(const std::vector<PartPieces>& parts, latin::FixedPoint& fixedPoint,
                            const latin::Iterate& state, int step,
                            const std::vector<latin::ResponseGradient>& gradients);

}  // namespace harmos::scene
