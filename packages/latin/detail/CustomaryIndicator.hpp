#pragma once

#include <harmos/latin/Iterate.hpp>

namespace harmos::latin {

/// The customary indicator |s - s^| / |s| [-] with s = (f, w) in the norm that k makes; not an error. Collective.
double customaryIndicator(const Iterate& state);

}  // namespace harmos::latin
