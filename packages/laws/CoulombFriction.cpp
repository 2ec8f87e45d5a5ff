#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with isotropic Coulomb friction, small sliding, implicit in the load step.
///
/// Normal: delta_n + g >= 0, t_n <= 0, (delta_n + g) t_n = 0.
/// Tangential, with s = delta_t - delta_t(previous step): |t_t| <= mu |t_n|; stick: s = 0; slip: t_t = mu |t_n| s/|s|.
/// History: delta_t at the end of the previous load step [length]. Source: Champaney, Blanze, Boucard (2004),
/// section 2.2.
struct CoulombFriction {
  static constexpr const char* name = "Coulomb Friction";
  static constexpr int historySize = 2;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Unilateral contact with isotropic Coulomb friction: |t_t| <= mu |t_n|, sliding along t_t.")
        .source("Champaney, Blanze, Boucard (2004), section 2.2");
    p.equation("opening >= 0, t_n <= 0, their product 0; |t_t| <= mu |t_n|, sliding along t_t");
    p.number("Friction Coefficient")
        .example("0.3")
        .unit("-")
        .required()
        .atLeast(0.0)
        .varying()
        .doc("Ratio of tangential to normal traction at sliding.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit CoulombFriction(const input::Parameters& p)
      : friction(p.schedule("Friction Coefficient")), gap(p.schedule("Gap")) {}

  AdmissibleTractions admissibleTractions(int step) const { return AdmissibleTractions::pressure(friction[step]); }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    LocalState state;
    const double opening = line.freeJump[0] + at.gap + gap[at.step];
    state.traction[0] = contactTraction(opening, line.compliance);
    if (opening >= 0.0) {
      state.status = Status::open;
    } else {
      const double limit = -friction[at.step] * state.traction[0];
      state.traction[1] = (line.freeJump[1] - old[0]) / line.compliance;
      state.traction[2] = (line.freeJump[2] - old[1]) / line.compliance;
      const double trial = tangentialNorm(state.traction);
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

  /// Friction alone dissipates: a pressure does work only where a gap closes within the load step, before it is there.
  double keptWork(const PairStep& step) const { return step.traction[0] * (step.jump[0] - step.oldJump[0]); }

  input::Schedule friction;
  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(CoulombFriction)

}  // namespace harmos::laws
