#pragma once

#include <algorithm>
#include <limits>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {

/// Coulomb friction under a pressure that is known, with a spring along the surface where it sticks: t_t = k_t (delta_t
/// - s), |t_t| <= min(mu p, tau). An open pair carries nothing, and sticks where it lands. History: SlipMemory.
struct StickingFriction : SlidingLaw {
  /// Declares its parameters.
  static void describe(input::ParameterSpec& p) {
    p.number("Friction Coefficient")
        .unit("-")
        .defaultValue(0.0)
        .atLeast(0.0)
        .varying()
        .doc("mu, ratio of tangential to normal traction at sliding.");
    p.number("Tangential Stiffness")
        .unit("stress/length")
        .optional()
        .above(0.0)
        .doc("k_t while it sticks; absent: rigid.");
    p.number("Shear Limit")
        .unit("stress")
        .optional()
        .above(0.0)
        .doc("tau, the most that friction carries at any pressure; absent: no limit.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit StickingFriction(const input::Parameters& p)
      : friction(p.schedule("Friction Coefficient")),
        gap(p.schedule("Gap")),
        compliance(p.has("Tangential Stiffness") ? 1.0 / p.number("Tangential Stiffness") : 0.0),
        limit(p.has("Shear Limit") ? p.number("Shear Limit") : std::numeric_limits<double>::infinity()) {}

  /// What a line leaves of the opening when nothing is carried [length].
  double freeOpening(const LocalLine& line, const NodeContext& at) const {
    return line.freeJump[0] + at.gap + gap[at.step];
  }
  /// The state that belongs to a pressure p >= 0 [stress] of a pair that is closed, or to an open one.
  LocalState slideUnder(const LocalLine& line, const NodeContext& at, bool isOpen, double pressure, const double* old,
                        double* now) const {
    if (isOpen) {
      SlipMemory::keep(Tangential::of(line.freeJump), 0.0, old, now);
      return {{}, Status::open};
    }
    const double most = std::min(friction[at.step] * pressure, limit);
    const SlipState slip = slipOnLine(line, compliance, SlipMemory::slip(old), {most, 0.0, 0.0});
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    return {{-pressure, slip.traction.t1, slip.traction.t2}, slip.slides ? Status::slip : Status::stick};
  }
  /// Pressure, and friction under it.
  AdmissibleTractions admissibleTractions(int step) const {
    return AdmissibleTractions::pressureAtMost(friction[step]);
  }
  /// min(mu p, tau) [stress].
  double shearLimit(const NodeContext& at, const base::Vector3& traction) const {
    return std::min(friction[at.step] * std::max(0.0, -traction[0]), limit);
  }
  /// Of the spring along the surface [stress length].
  double shearEnergy(const base::Vector3& traction) const {
    const double shear = tangentialNorm(traction);
    return 0.5 * compliance * shear * shear;
  }

  input::Schedule friction;
  input::Schedule gap;
  double compliance;  ///< 1 / k_t [length/stress], or 0
  double limit;       ///< tau [stress]
};

}  // namespace harmos::laws
