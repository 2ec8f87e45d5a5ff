#pragma once

#include <optional>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// Reports to `errors` what does not fit a scene of this many dimensions, with the place of each entry: the kinematics,
/// and directions and points with another number of components; besides, directions of length 0.
///
/// Without a dimension, because the mesh is not read yet, 2 and 3 components are both right.
void checkDimensions(const input::Parameters& scene, std::optional<int> dimension, input::ErrorList& errors);

}  // namespace harmos::scene
