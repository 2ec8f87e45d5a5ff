#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::latin {

/// Whether equal displacements at these places [length], at least one, are equal rigid motions: in the plane two of
/// them suffice, in space they must not lie on one line.
bool areFixed(const std::vector<base::Vector3>& places, int dimension);

}  // namespace harmos::latin
