#pragma once

#include <harmos/laws/LocalLine.hpp>

namespace harmos::laws {

/// Intersection of t = diag(k_n, k_t, k_t) delta with a line: t_i = k_i delta_free_i / (1 + k_i H).
///
/// The stiffnesses [stress/length] are >= 0; the form stays finite for k -> 0 and k -> infinity.
inline LocalState springTraction(const LocalLine& line, double normalStiffness, double tangentialStiffness) {
  const double n = normalStiffness / (1.0 + normalStiffness * line.compliance);
  const double t = tangentialStiffness / (1.0 + tangentialStiffness * line.compliance);
  return {{n * line.freeJump[0], t * line.freeJump[1], t * line.freeJump[2]}, Status::bonded};
}

/// Energy of such springs, t.delta / 2 [stress length].
inline double springEnergy(const base::Vector3& jump, const base::Vector3& traction) {
  return 0.5 * base::dot(traction, jump);
}

}  // namespace harmos::laws
