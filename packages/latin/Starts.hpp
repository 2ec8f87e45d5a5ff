#pragma once

#include <functional>

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// Replaces `alpha` (one column per load step) by a start for the iteration over all load steps: solves every third
/// step roughly, as if there were no others, and interpolates between them. Collective. Leaves `alpha` as it is when
/// there are too few steps or the iteration diverges.
void startFromCoarseSteps(FixedPoint& fixedPoint, base::Matrix& alpha, int memory);

/// Replaces `alpha` by what is found load step after load step, each with the history that the one before has left.
///
/// The slowest but surest way along a path: what a step does no longer depends on steps that are still moving. Each
/// step iterates until |T(alpha) - alpha| <= tolerance |f^| in the state metric, extrapolated from the two steps
/// before. Collective. Stops early when `mustStop` says so; the displacement formulation only.
void marchThroughSteps(FixedPoint& fixedPoint, base::Matrix& alpha, int memory, double tolerance,
                       const std::function<bool()>& mustStop);

}  // namespace harmos::latin
