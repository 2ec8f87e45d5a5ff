#include <utility>

#include <harmos/base/Numerals.hpp>
#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SofteningCurve.hpp>

namespace harmos::laws {
namespace {

/// Cohesive zone of mixed mode with irreversible damage d: t_n = (1 - d) K delta_n, t_t = (1 - d) K delta_t where the
/// sides are apart; where they are pressed together delta_n = 0, t_n <= 0, intact or broken, without friction.
///
/// With lambda^2 = <delta_n>^2 + |delta_t|^2 and the share of shear B = |delta_t|^2 / lambda^2, the same as that in the
/// energy release because K is one for all directions,
///   onset:  lambda_0^2 = (sigma_n / K)^2 + ((sigma_t / K)^2 - (sigma_n / K)^2) B^eta
///   energy: G = G_I + (G_II - G_I) B^eta   (Benzeggagh, Kenane 1996)
/// and a SofteningCurve of these; d is the largest damage that it has shown so far. On a line lambda has the direction
/// of the free jump, so that B is known and one number is looked for. It is the only one where H times the steepest
/// fall is below 1; otherwise the intact or less damaged one, as long as there is one.
/// Free energy (1 - d) K lambda^2 / 2; dissipated K lambda^2 / 2 per damage, G when it has failed at one mix of modes.
/// History: d [-], energy dissipated [energy/length^2].
/// Source: Turon, Camanho, Costa, Davila (2006), doi:10.1016/j.mechmat.2005.10.003; mixed mode by Benzeggagh, Kenane
/// (1996), doi:10.1016/0266-3538(96)00005-X.
struct CohesiveZone {
  static constexpr const char* name = "Cohesive Zone";
  static constexpr int historySize = 2;
  static constexpr Sides sides = Sides::two;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Glue or interface of a laminate that fails: elastic up to its strength, then softening with irreversible "
         "damage until the fracture energy is spent; opening and shear together; frictionless contact under pressure.")
        .source(
            "Turon, Camanho, Costa, Davila (2006), doi:10.1016/j.mechmat.2005.10.003; Benzeggagh, Kenane (1996), "
            "doi:10.1016/0266-3538(96)00005-X");
    p.equation(
        "t = (1 - d) K delta, d from 0 to 1 as the energy G_I + (G_II - G_I) B^eta is spent; closed: opening >= 0");
    p.number("Stiffness")
        .example("1e5")
        .unit("stress/length")
        .required()
        .above(0.0)
        .doc("K of the undamaged joint, in opening and in shear; under pressure it does not give way.");
    p.number("Normal Strength")
        .example("30")
        .unit("stress")
        .required()
        .above(0.0)
        .doc("Largest traction in pure opening (mode I).");
    p.number("Shear Strength")
        .example("40")
        .unit("stress")
        .required()
        .above(0.0)
        .doc("Largest traction in pure shear (mode II).");
    p.number("Mode I Fracture Energy")
        .example("0.3")
        .unit("energy/length^2")
        .required()
        .above(0.0)
        .doc("G_I, the area below the curve in pure opening; more than the square of the strength over 2 Stiffness.");
    p.number("Mode II Fracture Energy")
        .example("0.9")
        .unit("energy/length^2")
        .required()
        .above(0.0)
        .doc("G_II, the area below the curve in pure shear; more than the square of the strength over 2 Stiffness.");
    p.number("Mixed Mode Exponent")
        .unit("-")
        .defaultValue(1.0)
        .atLeast(0.1)
        .doc(
            "eta of Benzeggagh and Kenane: G = G_I + (G_II - G_I) B^eta, B the share of shear in the energy; 1: in "
            "proportion. Measured values for laminates lie between 1 and 3.");
    p.text("Softening")
        .defaultValue("Bilinear")
        .oneOf({"Bilinear", "Exponential"})
        .doc("How the traction falls: linearly to zero, or exponentially.");
  }

  /// Something must be left for softening once the strength is reached.
  static void check(const input::Parameters& p, input::ErrorList& errors) {
    for (const auto& [strength, energy] : {std::pair{"Normal Strength", "Mode I Fracture Energy"},
                                           std::pair{"Shear Strength", "Mode II Fracture Energy"}}) {
      const double t = p.number(strength), elastic = 0.5 * t * t / p.number("Stiffness");
      if (p.number(energy) > elastic) continue;
      errors.add(p.where(energy),
                 base::toText(p.number(energy)) + " is not more than the elastic energy at the strength, " + strength +
                     "^2 / (2 Stiffness) = " + base::toText(elastic) + ".",
                 std::string("Raise ") + energy + " or Stiffness, or lower " + strength + ".");
    }
  }

  explicit CohesiveZone(const input::Parameters& p)
      : shape(p.text("Softening") == "Bilinear" ? Softening::bilinear : Softening::exponential),
        stiffness(p.number("Stiffness")),
        normalOnset(p.number("Normal Strength") / stiffness),
        shearOnset(p.number("Shear Strength") / stiffness),
        normalEnergy(p.number("Mode I Fracture Energy")),
        shearEnergy(p.number("Mode II Fracture Energy")),
        exponent(p.number("Mixed Mode Exponent")) {}

  /// Largest at one of the pure modes: the squares of onsets and the energies are linear in B^eta.
  double lowestSlope() const { return -std::max(curve(0.0).steepestFall(), curve(1.0).steepestFall()); }

  LocalState solve(const LocalLine& line, const NodeContext&, const double* old, double* now) const {
    const bool isPressed = line.freeJump[0] < 0.0;
    const base::Vector3 apart{isPressed ? 0.0 : line.freeJump[0], line.freeJump[1], line.freeJump[2]};
    const double shear = tangentialNorm(apart), free = std::hypot(apart[0], shear);
    const SofteningCurve curve = this->curve(free > 0.0 ? (shear / free) * (shear / free) : 0.0);
    double damage = old[0], energy = old[1];
    const double kept = free / (1.0 + line.compliance * (1.0 - damage) * stiffness);
    if (curve.damage(kept) > damage) {
      const double opening = curve.intersect(free, line.compliance);
      energy += std::max(0.0, curve.dissipated(opening) - curve.dissipated(curve.opening(damage)));
      damage = std::max(damage, curve.damage(opening));
    }
    now[0] = damage;
    now[1] = energy;
    const double secant = (1.0 - damage) * stiffness;
    LocalState state{(secant / (1.0 + line.compliance * secant)) * apart, Status::bonded};
    if (isPressed) state.traction[0] = line.freeJump[0] / line.compliance;
    if (damage >= 1.0) state.status = isPressed ? Status::slip : Status::broken;
    return state;
  }

  /// Everything but what the damage has cost.
  double keptWork(const PairStep& step) const { return step.work() - (step.history[1] - step.oldHistory[1]); }
  /// Of the opening; what presses the sides together does no work.
  double storedEnergy(const PairStep& step) const {
    return 0.5 * (std::max(0.0, step.traction[0] * step.jump[0]) + step.traction[1] * step.jump[1] +
                  step.traction[2] * step.jump[2]);
  }
  static std::vector<OutputField> outputs() { return {{"damage", "-", "share of the stiffness that is lost"}}; }
  static void output(const PairStep& step, double* values) { values[0] = step.history[0]; }

 private:
  SofteningCurve curve(double shareOfShear) const {
    const double x = std::pow(shareOfShear, exponent), n = normalOnset * normalOnset;
    return {shape, stiffness, std::sqrt(n + (shearOnset * shearOnset - n) * x),
            normalEnergy + (shearEnergy - normalEnergy) * x};
  }

  Softening shape;
  double stiffness, normalOnset, shearOnset, normalEnergy, shearEnergy, exponent;
};

}  // namespace

HARMOS_INTERFACE_LAW(CohesiveZone)

}  // namespace harmos::laws
