#pragma once

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/detail/Faults.hpp>

namespace harmos::assembly {

/// What all ranks know of body `index`: dimension, nodes and the body that it is congruent to.
void checkBody(const Assembly& assembly, int index, Faults& faults);

/// What its owner alone knows: matrix and loads. The rest must be in order.
void checkOwnedBody(const Assembly& assembly, int index, Faults& faults);

}  // namespace harmos::assembly
