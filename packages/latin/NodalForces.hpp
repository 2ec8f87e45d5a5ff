#pragma once

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/TraceLayout.hpp>

namespace harmos::latin {

/// B^T h f, added up over the interfaces at every node, over the square root of the sum of |B|^T h: a single interface
/// on a node of its own gives sqrt(h) f. Rows: the nodes of the layout x dimension; a single 0 when there are none.
///
/// Only these sums act on a body, and only they are determinate where three bodies, or two bodies and a fixed boundary,
/// meet.
base::Matrix nodalForces(const TraceLayout& layout, const base::Matrix& traction);

}  // namespace harmos::latin
