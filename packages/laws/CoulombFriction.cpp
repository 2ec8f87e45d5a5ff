#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/FrictionalContact.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with isotropic Coulomb friction, small sliding, implicit in the load step, see frictionalContact.
/// History: delta_t at the end of the previous load step [length].
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
    return frictionalContact(line, line.freeJump[0] + at.gap + gap[at.step], friction[at.step], old, now);
  }

  /// Friction alone dissipates: a pressure does work only where a gap closes within the load step, before it is there.
  double keptWork(const PairStep& step) const { return step.traction[0] * (step.jump[0] - step.oldJump[0]); }

  input::Schedule friction;
  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(CoulombFriction)

}  // namespace harmos::laws
