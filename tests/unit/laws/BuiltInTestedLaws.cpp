#include "TestedLaws.hpp"

#include <cmath>

namespace harmos::laws {
namespace {

/// What laws of others may do and none of Harmos does: look at the place, ask for the duration where work is kept, and
/// leave it to the jump what a slider has lost. Along the normal Kelvin's body, along the surface a slider.
struct PlacedSlider {
  static constexpr const char* name = "Placed Slider";
  static constexpr int historySize = 3;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Slider whose limit depends on the place, beside Kelvin's body along the normal.");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("Of the spring.");
    p.number("Viscosity").unit("stress time/length").required().above(0.0).doc("Of the dashpot.");
    p.number("Limit").unit("stress").required().atLeast(0.0).doc("Of the slider, where x is 0.");
    p.number("Length").unit("length").required().above(0.0).doc("Over which the limit grows by itself.");
  }

  explicit PlacedSlider(const input::Parameters& p)
      : stiffness(p.number("Stiffness")),
        viscosity(p.number("Viscosity")),
        limit(p.number("Limit")),
        length(p.number("Length")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double h = line.compliance, time = at.duration();
    const base::Vector3& free = line.freeJump;
    const double normal =
        (stiffness * time * free[0] + viscosity * (free[0] - old[0])) / (time + h * (stiffness * time + viscosity));
    const double t1 = (free[1] - old[1]) / h, t2 = (free[2] - old[2]) / h, size = std::hypot(t1, t2);
    const double most = limit * (1.0 + at.position()[0] / length), share = size > most ? most / size : 1.0;
    const LocalState state{{normal, share * t1, share * t2}, size > most ? Status::slip : Status::stick};
    const base::Vector3 jump = line.jump(state.traction);
    for (std::size_t c = 0; c < 3; ++c) now[c] = jump[c];
    return state;
  }
  double keptWork(const PairStep& step) const {
    const double moved = step.jump[0] - step.oldJump[0];
    return step.traction[0] * moved - viscosity * moved * moved / step.at.duration();
  }
  double storedEnergy(const PairStep& step) const { return 0.5 * stiffness * step.jump[0] * step.jump[0]; }

  double stiffness, viscosity, limit, length;
};

}  // namespace

LawRegistry testedLaws() {
  LawRegistry laws = builtInLaws();
  addLaw<PlacedSlider>(laws);
  return laws;
}

std::vector<std::string> untestedLaws() {
  // Of whole faces, not of pairs: FaceLawTest and CoupledLawTest. With axes of their own: CylindricalTest and ToolsTest
  // in tests/verification. Of texts: FormulaLawTest.
  return {"Cylindrical Displacement", "Cylindrical Traction", "Face Spring",    "Formula",     "Pretension",
          "Remote Displacement",      "Remote Force",         "Rigid Cylinder", "Rigid Plane", "Rigid Sphere"};
}

}  // namespace harmos::laws
