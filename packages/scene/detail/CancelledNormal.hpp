#pragma once

namespace harmos::scene {

/// Length of a sum of normals over the sum of their areas that is nothing but round-off.
constexpr double cancelledNormal = 1e-9;

}  // namespace harmos::scene
