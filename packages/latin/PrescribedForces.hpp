#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>

namespace harmos::latin {

/// Nodal forces h f [force] of a boundary whose law prescribes its traction: pairs x dimension, global components.
/// `step`: load step, from 0. Not collective.
std::vector<double> prescribedForces(const assembly::Interface& interface, int dimension, int step);

}  // namespace harmos::latin
