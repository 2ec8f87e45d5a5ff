#pragma once

#include <string>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::assembly {

/// Why a boundary cannot be a load of a PathControl, a sentence without a full stop; empty: it can. `index`: position
/// in the assembly. Not collective.
std::string faultOfLoad(const Assembly& assembly, int index);

}  // namespace harmos::assembly
