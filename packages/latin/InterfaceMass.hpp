#pragma once

#include <harmos/base/Matrix.hpp>
#include <harmos/interface/Interface.hpp>

namespace harmos::latin {

/// y = h x for one interface side: `x` and `y` hold pairs x dimension rows, node by node, in one column; they must
/// differ.
void applyMass(const interface::Interface& interface, int dimension, const double* x, double* y);

}  // namespace harmos::latin
