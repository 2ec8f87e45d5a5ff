#pragma once

#include <array>
#include <cmath>

namespace harmos::laws {

/// Components (n, t1, t2) of an interface node's frame, or (x, y, z) for laws that work in the global frame.
using Vector3 = std::array<double, 3>;

inline double tangentialNorm(const Vector3& v) {
  return std::hypot(v[1], v[2]);
}

}  // namespace harmos::laws
