#include <harmos/laws/detail/StickingFriction.hpp>

namespace harmos::laws {
namespace {

/// Contact of surfaces that give way: p = k_n x with the overclosure x = max(0, -(delta_n + g)), and Coulomb friction
/// with a tangential stiffness where it sticks, see StickingFriction.
/// Source: Oden, Martins (1985), with exponents 1; known as penalty contact.
struct CompliantContact {
  static constexpr const char* name = "Compliant Contact";
  static constexpr int historySize = StickingFriction::historySize;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact of surfaces that give way: pressure = stiffness times overclosure, with Coulomb friction and a "
         "stiffness along the surface while it sticks (penalty contact).")
        .source("Oden, Martins (1985)");
    p.number("Normal Stiffness")
        .unit("stress/length")
        .required()
        .above(0.0)
        .varying()
        .doc("k_n, pressure by overclosure.");
    StickingFriction::describe(p);
  }

  explicit CompliantContact(const input::Parameters& p) : stiffness(p.schedule("Normal Stiffness")), shear(p) {}

  AdmissibleTractions admissibleTractions(int step) const {
    return AdmissibleTractions::pressure(shear.friction[step]);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double opening = shear.freeOpening(line, at);
    const double k = stiffness[at.step];
    return shear.solve(line, at, opening >= 0.0, -k * opening / (1.0 + k * line.compliance), old, now);
  }

  double keptWork(const PairStep& step) const { return shear.keptWork(step); }
  double storedEnergy(const PairStep& step) const {
    const double pressure = step.traction[0];
    return 0.5 * pressure * pressure / stiffness[step.at.step] + shear.storedEnergy(step.traction);
  }
  static std::vector<OutputField> outputs() { return SlipMemory::outputs(); }
  void output(const PairStep& step, double* values) const { values[0] = SlipMemory::way(step.history); }

  input::Schedule stiffness;
  StickingFriction shear;
};

}  // namespace

HARMOS_INTERFACE_LAW(CompliantContact)

}  // namespace harmos::laws
