#pragma once

#include <algorithm>

#include <harmos/latin/LinearStage.hpp>

namespace harmos::latin {

/// u [length] of so many nodes of a body in space as last solved, components of nodes x columns selected.
inline base::Matrix displacementsOf(const LinearStage& stage, int body, std::size_t nodes) {
  base::Matrix u(3 * static_cast<int>(nodes), stage.trace().numCols());
  for (int t = 0; t < u.numCols(); ++t) {
    for (int a = 0; a < static_cast<int>(nodes); ++a) {
      const base::Vector3 at = stage.displacement(body, a, t);
      std::copy(at.begin(), at.end(), u[t] + 3 * a);
    }
  }
  return u;
}

}  // namespace harmos::latin
