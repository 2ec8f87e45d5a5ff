#include <harmos/laws/detail/StickingFriction.hpp>

namespace harmos::laws {
namespace {

/// Contact of surfaces that give way: p = k_n x with the overclosure x = max(0, -(delta_n + g)), and Coulomb friction
/// with a tangential stiffness where it sticks, see StickingFriction.
/// Source: Oden, Martins (1985), with exponents 1; known as penalty contact.
struct CompliantContact : StickingFriction {
  static constexpr const char* name = "Compliant Contact";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact of surfaces that give way: pressure = stiffness times overclosure, with Coulomb friction and a "
         "stiffness along the surface while it sticks (penalty contact).")
        .source("Oden, Martins (1985)");
    p.equation("p = k_n max(0, -opening); t_t = k_t (delta_t - s), |t_t| <= min(mu p, tau)");
    p.number("Normal Stiffness")
        .example("1e4")
        .unit("stress/length")
        .required()
        .above(0.0)
        .varying()
        .doc("k_n, pressure by overclosure.");
    StickingFriction::describe(p);
  }

  explicit CompliantContact(const input::Parameters& p)
      : StickingFriction(p), stiffness(p.schedule("Normal Stiffness")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double opening = freeOpening(line, at);
    const double k = stiffness[at.step];
    return slideUnder(line, at, opening >= 0.0, -k * opening / (1.0 + k * line.compliance), old, now);
  }

  double storedEnergy(const PairStep& step) const {
    const double pressure = step.traction[0];
    return 0.5 * pressure * pressure / stiffness[step.at.step] + shearEnergy(step.traction);
  }

  input::Schedule stiffness;
};

}  // namespace

HARMOS_INTERFACE_LAW(CompliantContact)

}  // namespace harmos::laws
