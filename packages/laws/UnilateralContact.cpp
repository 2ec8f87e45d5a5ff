#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>

namespace harmos::laws {
namespace {

/// Frictionless unilateral contact with an initial gap g (interference when negative):
/// delta_n + g >= 0, t_n <= 0, (delta_n + g) t_n = 0, t_t = 0. Source: Signorini's conditions.
struct UnilateralContact {
  static constexpr const char* name = "Unilateral Contact";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::any;

  static void describe(input::ParameterSpec& p) {
    p.summary("Frictionless unilateral contact: opening >= 0, pressure >= 0, their product 0.")
        .source("Signorini's conditions; Champaney, Blanze, Boucard (2004), section 2.2");
    p.equation("opening >= 0, t_n <= 0, opening t_n = 0");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit UnilateralContact(const input::Parameters& p) : gap(p.schedule("Gap")) {}

  AdmissibleTractions admissibleTractions(int) const { return AdmissibleTractions::pressure(0.0); }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    const double opening = line.freeJump[0] + at.gap + gap[at.step];
    return {{contactTraction(opening, line.compliance), 0.0, 0.0}, opening >= 0.0 ? Status::open : Status::slip};
  }

  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(UnilateralContact)

}  // namespace harmos::laws
