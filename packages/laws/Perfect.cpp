#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Perfect joint: delta = 0, so t = delta_free / H. Source: Champaney, Blanze, Boucard (2004), eq. (7).
struct Perfect {
  static constexpr const char* name = "Perfect";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  static constexpr bool bonds = true;
  static constexpr bool isAffine = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Perfect joint: both sides move together, delta = 0.")
        .source("Champaney, Blanze, Boucard (2004), eq. (7)");
    p.equation("delta = 0");
  }

  explicit Perfect(const input::Parameters&) {}

  AdmissibleTractions admissibleTractions(int) const { return {}; }

  LocalState solve(const LocalLine& line, const NodeContext&, const double*, double*) const {
    const double s = 1.0 / line.compliance;
    return {{s * line.freeJump[0], s * line.freeJump[1], s * line.freeJump[2]}, Status::bonded};
  }
};

}  // namespace

HARMOS_INTERFACE_LAW(Perfect)

}  // namespace harmos::laws
