#pragma once

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// Collective, one load step selected. Round-off in the images L of the linear stage, in the metric of states [force
/// length, square root]: L is affine, so that L(a + d) - 2 L(a) + L(a - d) is nothing else. a is `state`, one column, d
/// drawn, as large as a.
///
/// Slender parts on soft springs lose as many digits as their stiffnesses in bending and in extension are apart.
/// Costs a few columns of a linear stage. No iterate is valid afterwards.
double noiseOfImages(FixedPoint& fixedPoint, const base::Matrix& state);

/// Collective, all load steps selected. The same, field by field [stress] and with a margin, of the load step at which
/// a state with this beta is largest, on the line from nothing through it: d drawn would move parts on soft springs
/// farther than they are. Costs two columns of a linear stage. No iterate is valid afterwards.
base::Matrix noiseAlong(FixedPoint& fixedPoint, const base::Matrix& alpha, const base::Matrix& beta);

}  // namespace harmos::latin
