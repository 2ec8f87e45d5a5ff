#pragma once

#include <harmos/input/Parameters.hpp>
#include <harmos/input/Schedule.hpp>
#include <harmos/laws/PointwiseLaw.hpp>

namespace harmos::laws {

/// What the laws of a spring along the normal and one along the tangents share: t = diag(k_n, k_t, k_t) delta, the
/// ground in place of the second part included. The stiffnesses [stress/length], >= 0, may change from step to step.
struct SpringLaw {
  static constexpr int historySize = 0;
  static constexpr bool isAffine = true;

  explicit SpringLaw(const input::Parameters& p)
      : normal(p.schedule("Normal Stiffness")), tangential(p.schedule("Tangential Stiffness")) {}

  AdmissibleTractions admissibleTractions(int step) const {
    return AdmissibleTractions::components(normal[step] > 0.0, tangential[step] > 0.0, tangential[step] > 0.0);
  }

  /// t_i = k_i delta_free_i / (1 + k_i H), which stays finite for k -> 0 and k -> infinity.
  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    const double n = normal[at.step] / (1.0 + normal[at.step] * line.compliance);
    const double t = tangential[at.step] / (1.0 + tangential[at.step] * line.compliance);
    return {{n * line.freeJump[0], t * line.freeJump[1], t * line.freeJump[2]}, Status::bonded};
  }

  double storedEnergy(const PairStep& step) const { return 0.5 * base::dot(step.traction, step.jump); }

  input::Schedule normal;
  input::Schedule tangential;
};

}  // namespace harmos::laws
