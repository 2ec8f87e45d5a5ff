#pragma once

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/detail/Faults.hpp>

namespace harmos::assembly {

/// Whether interface `index` fits the bodies, which must be in order.
void checkInterface(const Assembly& assembly, int index, Faults& faults);

}  // namespace harmos::assembly
