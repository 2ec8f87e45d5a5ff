#include <algorithm>
#include <cmath>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/NormalSpring.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {
namespace {

// Newton's method in a bracket, which is halved where it leaves it.
constexpr int mostSteps = 200;
// Of m: Newton's step after one as short as that is round-off.
constexpr double converged = 1e-12;

/// Smooth hysteresis along the surface: t_t = a k delta_t + (1 - a) k z, z' = delta' - z (|z|^(n-2) / Z^n) (s
/// |delta'.z|
/// + (1 - s) delta'.z).
///
/// Z = tau / ((1 - a) k) is the bound of |z|; s = beta / (beta + gamma) >= 1/2, so that nothing is won. Over a load
/// step z = y / (1 + q |z|^(n-1)) lies along y = z_old + delta - delta_old, with q Z^n = |y| - |z_old| where that grows
/// and (2 s - 1) (|z_old| - |y|) where it falls: implicit Euler, with delta'.z as |z| |z|'. So z is the gradient of a
/// convex function of delta whatever the load step, and its error is proportional to its length. History: z, delta_t
/// [length]. Sources: Wen (1976); Park, Wen, Ang (1986) for two directions; Erlicher, Point (2004) for its energy k z.z
/// / 2.
struct BoucWen {
  static constexpr const char* name = "Bouc-Wen";
  static constexpr int historySize = 4;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Joint along the surface with smooth hysteresis: a spring beside an element that goes over from its stiffness "
         "to its strength, the sharper the larger the exponent.")
        .source("Wen (1976); Park, Wen, Ang (1986); Erlicher, Point (2004)");
    p.equation("t_t = a k delta_t + (1 - a) k z, z' = delta' - z |z|^(n-2) / Z^n (s |delta'.z| + (1 - s) delta'.z)");
    p.number("Tangential Stiffness").example("1000").unit("stress/length").required().above(0.0).doc("k at first.");
    p.number("Slip Limit")
        .example("5")
        .unit("stress")
        .required()
        .above(0.0)
        .doc("tau, the strength of the hysteretic part; Z = (A / (beta + gamma))^(1/n) is tau / ((1 - a) k).");
    p.number("Residual Stiffness Ratio")
        .unit("-")
        .defaultValue(0.0)
        .atLeast(0.0)
        .below(1.0)
        .doc("a: stiffness at last over that at first.");
    p.number("Exponent").unit("-").defaultValue(2.0).atLeast(1.0).doc("n.");
    p.number("Unloading Shape")
        .unit("-")
        .defaultValue(0.5)
        .atLeast(0.5)
        .doc("s = beta / (beta + gamma); at 0.5 it unloads with the stiffness k, above along a curve.");
    NormalSpring::describe(p);
  }

  explicit BoucWen(const input::Parameters& p)
      : normal(p),
        spring(p.number("Residual Stiffness Ratio") * p.number("Tangential Stiffness")),
        stiffness(p.number("Tangential Stiffness") - spring),
        bound(p.number("Slip Limit") / stiffness),
        exponent(p.number("Exponent")),
        shape(p.number("Unloading Shape")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const Tangential oldZ{old[0], old[1]}, oldJump{old[2], old[3]}, free = Tangential::of(line.freeJump);
    // On the line delta = share (delta_free - H (1 - a) k z), so that y + h z = reach.
    const double share = 1.0 / (1.0 + line.compliance * spring), h = share * line.compliance * stiffness;
    const Tangential reach = oldZ + share * free - oldJump;
    const double length = reach.norm();
    const double size = length > 0.0 ? sizeOnLine(length, h, oldZ.norm()) : length;
    const Tangential z = length > 0.0 ? (size / length) * reach : reach;
    const Tangential traction = (share * spring) * free + (share * stiffness) * z;
    const Tangential jump = free - line.compliance * traction;
    now[0] = z.t1;
    now[1] = z.t2;
    now[2] = jump.t1;
    now[3] = jump.t2;
    return {{normal.traction(line, at.gap), traction.t1, traction.t2},
            size > oldZ.norm() ? Status::slip : Status::stick};
  }

  /// All but what z falls behind delta by.
  double keptWork(const PairStep& step) const {
    const Tangential z = zOf(step.history), moved = Tangential::of(step.jump) - Tangential::of(step.oldJump);
    return step.work() - stiffness * dot(z, moved - (z - zOf(step.oldHistory)));
  }
  double storedEnergy(const PairStep& step) const {
    const Tangential z = zOf(step.history), jump = Tangential::of(step.jump);
    return normal.energy(step.traction[0]) + 0.5 * (spring * dot(jump, jump) + stiffness * dot(z, z));
  }
  static std::vector<OutputField> outputs() {
    return {{"share_of_strength", "-", "what the hysteretic part carries over its strength"}};
  }
  void output(const PairStep& step, double* values) const { values[0] = zOf(step.history).norm() / bound; }

 private:
  static Tangential zOf(const double* history) { return {history[0], history[1]}; }

  /// m = |z| >= 0 where m + q m^n = |y| and |y| + h m = `length`.
  double sizeOnLine(double length, double h, double oldSize) const {
    const double elastic = length / (1.0 + h);
    const double factor = elastic >= oldSize ? 1.0 : 1.0 - 2.0 * shape;
    double low = 0.0, high = elastic, m = std::min(elastic, bound);
    for (int step = 0; step < mostSteps; ++step) {
      const double power = std::pow(m / bound, exponent), grown = factor * (length - h * m - oldSize);
      const double value = (1.0 + h) * m + grown * power - length;
      (value > 0.0 ? high : low) = m;
      const double slope = 1.0 + h * (1.0 - factor * power) + exponent * grown * (m > 0.0 ? power / m : 0.0);
      double next = m - value / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - m) <= converged * m) return next;
      m = next;
    }
    return m;
  }

  NormalSpring normal;
  double spring;     ///< a k [stress/length]
  double stiffness;  ///< (1 - a) k [stress/length]
  double bound;      ///< Z [length]
  double exponent, shape;
};

}  // namespace

HARMOS_INTERFACE_LAW(BoucWen)

}  // namespace harmos::laws
