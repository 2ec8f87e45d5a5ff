#pragma once

#include <array>

#include <harmos/base/Vector3.hpp>

namespace harmos::latin {

/// Work of the force f at the arm r [length] in the unit translations and rotations: (f, r x f).
inline std::array<double, 6> rigidWork(const base::Vector3& r, const base::Vector3& f) {
  const base::Vector3 moment = base::cross(r, f);
  return {f[0], f[1], f[2], moment[0], moment[1], moment[2]};
}

}  // namespace harmos::latin
