#pragma once

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Matrix.hpp>

namespace harmos::latin {

/// y = h x for one interface side: `x` and `y` hold pairs x dimension rows, node by node, in one column; they must
/// differ. h: the consistent interface mass where there is one, else the areas of the pairs [area].
void applyMass(const assembly::Interface& interface, int dimension, const double* x, double* y);

}  // namespace harmos::latin
