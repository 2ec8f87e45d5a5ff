#include <harmos/laws/detail/BuiltIn.hpp>

namespace harmos::laws {
namespace {

/// Bolt preload as a prescribed axial relative displacement g(t) of two faces, glued otherwise:
/// delta_n = -g (g > 0 draws the faces into each other: tension), delta_t = 0.
/// At a crease the jump would have to be along two normals.
/// Source: Champaney, Blanze, Boucard (2004), section 3.2.
struct PreloadJump {
  static constexpr const char* name = "Preload Jump";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  static constexpr bool isAffine = true;
  static constexpr Creases creases = Creases::refuse;

  static void describe(input::ParameterSpec& p) {
    p.summary("Bolt preload: prescribed axial overlap of the two faces, joined perfectly otherwise.")
        .source("Champaney, Blanze, Boucard (2004), section 3.2");
    p.equation("delta_n = -g(t), delta_t = 0");
    p.number("Jump").example("0.01").unit("length").required().varying().doc(
        "Prescribed relative displacement of the faces along the normal; positive tightens the bolt.");
  }

  explicit PreloadJump(const input::Parameters& p) : jump(p.schedule("Jump")) {}

  AdmissibleTractions admissibleTractions(int) const { return {}; }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    const double s = 1.0 / line.compliance;
    return {{s * (line.freeJump[0] + jump[at.step]), s * line.freeJump[1], s * line.freeJump[2]}, Status::bonded};
  }

  input::Schedule jump;
};

}  // namespace

HARMOS_INTERFACE_LAW(PreloadJump)

}  // namespace harmos::laws
