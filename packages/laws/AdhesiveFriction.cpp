#include <algorithm>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact that attracts, with friction and cohesion.
///
/// Over the contact pressure p lies an attraction that falls with the opening x = delta_n + g: t_n = a max(0, 1 - x/d)
/// - p, x >= 0, p >= 0, x p = 0. It is the same on the way back: nothing breaks, and closing heals. |t_t| <= c + mu
/// |t_n| under pressure, and falls linearly to 0 where the pair opens, at t_n = a. The graph falls by a/d at the
/// steepest. Sources: Derjaguin, Muller, Toporov (1975) for the attraction beside the contact; Mohr, Coulomb for
/// cohesion.
struct AdhesiveFriction : SlidingLaw {
  static constexpr const char* name = "Adhesive Friction";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact that attracts up to a distance, with Coulomb friction and cohesion: |t_t| <= c + mu |t_n| in "
         "contact. "
         "What has come apart adheres again where it closes.")
        .source("Derjaguin, Muller, Toporov (1975); Mohr, Coulomb");
    p.equation(
        "opening >= 0, t_n = a max(0, 1 - opening / d) - p, p >= 0, p opening = 0; where opening = 0: |t_t| <= c + mu "
        "|t_n| if t_n < 0, else c (1 - t_n / a)");
    p.number("Friction Coefficient").example("0.2").unit("-").defaultValue(0.0).atLeast(0.0).varying().doc("mu.");
    p.number("Cohesion")
        .unit("stress")
        .defaultValue(0.0)
        .atLeast(0.0)
        .doc("c, what friction carries where nothing presses; wants an adhesion.");
    p.number("Adhesion").example("2").unit("stress").required().above(0.0).doc("a, tension at which the sides part.");
    p.number("Range").example("0.1").unit("length").required().above(0.0).doc(
        "d, opening from which on nothing attracts.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit AdhesiveFriction(const input::Parameters& p)
      : friction(p.schedule("Friction Coefficient")),
        gap(p.schedule("Gap")),
        cohesion(p.number("Cohesion")),
        adhesion(p.number("Adhesion")),
        range(p.number("Range")) {}

  double lowestSlope() const { return -adhesion / range; }

  /// Under tension what cohesion has left.
  double shearLimitAt(int step, double normal) const {
    if (normal < 0.0) return cohesion - friction[step] * normal;
    return cohesion * std::max(0.0, 1.0 - normal / adhesion);
  }
  double shearLimit(const NodeContext& at, const base::Vector3& traction) const {
    return shearLimitAt(at.step, traction[0]);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double free = line.freeJump[0] + at.gap + gap[at.step];
    const double closed = free / line.compliance;  // t_n where the sides touch
    if (closed >= adhesion) {
      SlipMemory::keep(Tangential::of(line.freeJump), 0.0, old, now);
      // Beyond the range, or on a line too soft for this law, it lets go.
      const double pull = adhesion * (range - free) / (range - line.compliance * adhesion);
      if (free < range) return {{pull, 0.0, 0.0}, Status::bonded};
      return {{}, Status::open};
    }
    const SlipState slip = slipOnLine(line, 0.0, SlipMemory::slip(old), {shearLimitAt(at.step, closed), 0.0, 0.0});
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    return {{closed, slip.traction.t1, slip.traction.t2}, slip.slides ? Status::slip : Status::stick};
  }

  /// Of the attraction, 0 in contact: what it has taken to come so far apart [stress length].
  double storedEnergy(const PairStep& step) const {
    const double opening = std::clamp(step.jump[0] + step.at.gap + gap[step.at.step], 0.0, range);
    return adhesion * opening * (1.0 - 0.5 * opening / range);
  }

  input::Schedule friction;
  input::Schedule gap;
  double cohesion, adhesion, range;
};

}  // namespace

HARMOS_INTERFACE_LAW(AdhesiveFriction)

}  // namespace harmos::laws
