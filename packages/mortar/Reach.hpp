#pragma once

#include <optional>

namespace harmos::mortar {

/// How far apart faces may lie along their normals and yet be joined.
struct Reach {
  std::optional<double> distance;  // [length]; none: relative to the faces
  double relative = 1.0;           // then, over the longest edge of both faces [-]
};

}  // namespace harmos::mortar
