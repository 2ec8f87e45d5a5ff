#pragma once

#include <harmos/base/Vector3.hpp>
#include <harmos/laws/LocalLine.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {

/// Where unilateral contact with Coulomb friction meets a line, implicit in the load step.
///
/// Normal: delta_n + gap >= 0, t_n <= 0, (delta_n + gap) t_n = 0. Tangential, with s = delta_t - delta_t(previous
/// step): |t_t| <= friction |t_n|; stick: s = 0; slip: t_t = friction |t_n| s/|s|. `old` and `now` [length]: delta_t at
/// the end of the previous load step and of this one, two numbers. Source: Champaney, Blanze, Boucard (2004),
/// section 2.2.
inline LocalState frictionalContact(const LocalLine& line, double opening, double friction, const double* old,
                                    double* now) {
  LocalState state;
  state.traction[0] = contactTraction(opening, line.compliance);
  if (opening >= 0.0) {
    state.status = Status::open;
  } else {
    const double limit = -friction * state.traction[0];
    state.traction[1] = (line.freeJump[1] - old[0]) / line.compliance;
    state.traction[2] = (line.freeJump[2] - old[1]) / line.compliance;
    const double trial = Tangential::of(state.traction).norm();
    if (trial >= limit) {
      const double scale = trial > 0.0 ? limit / trial : 0.0;
      state.traction[1] *= scale;
      state.traction[2] *= scale;
    }
    state.status = trial >= (1.0 - atTheLimit) * limit ? Status::slip : Status::stick;
  }
  const base::Vector3 jump = line.jump(state.traction);
  now[0] = jump[1];
  now[1] = jump[2];
  return state;
}

}  // namespace harmos::laws
