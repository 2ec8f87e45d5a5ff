#include <algorithm>
#include <cmath>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/TangentialSlip.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with friction that depends on the velocity of slip: mu(v) = mu_k + (mu_s - mu_k) exp(-v / v_c).
///
/// The coefficient of a load step is that of the velocity at the end of the one before, so that every load step has the
/// graph of Coulomb's law: it loses no solution and gains none, and the error in time is of first order. History: slip,
/// its way [length], the velocity, and that which the coefficient belongs to, which stays in a load step without
/// duration [length/time]. Source: Bengisu, Akay (1994); explicit in the velocity.
struct RateDependentFriction {
  static constexpr const char* name = "Rate-Dependent Friction";
  static constexpr int historySize = SlipMemory::size + 2;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with friction that falls, or rises, with the velocity of slip: mu = mu_k + (mu_s - mu_k) exp(-v / "
         "v_c), with v at the end of the load step before. Time is that of the steps.")
        .source("Bengisu, Akay (1994)");
    p.number("Static Coefficient").unit("-").required().atLeast(0.0).doc("mu_s at rest.");
    p.number("Kinetic Coefficient").unit("-").required().atLeast(0.0).doc("mu_k at large velocities.");
    p.number("Velocity").unit("length/time").required().above(0.0).doc("v_c, over which the coefficient changes.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit RateDependentFriction(const input::Parameters& p)
      : atRest(p.number("Static Coefficient")),
        moving(p.number("Kinetic Coefficient")),
        velocity(p.number("Velocity")),
        gap(p.schedule("Gap")) {}

  double coefficient(double speed) const { return moving + (atRest - moving) * std::exp(-speed / velocity); }

  AdmissibleTractions admissibleTractions(int) const { return AdmissibleTractions::pressure(std::max(atRest, moving)); }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double opening = line.freeJump[0] + at.gap + gap[at.step];
    double& speed = now[SlipMemory::size];
    const double before = old[at.duration() > 0.0 ? SlipMemory::size : SlipMemory::size + 1];
    now[SlipMemory::size + 1] = before;
    if (opening >= 0.0) {
      SlipMemory::keep(Tangential::of(line.freeJump), 0.0, old, now);
      speed = 0.0;
      return {{}, Status::open};
    }
    const double normal = contactTraction(opening, line.compliance);
    const double limit = -coefficient(before) * normal;
    const SlipState slip = slipOnLine(line, 0.0, SlipMemory::slip(old), {limit, 0.0, 0.0});
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    speed = at.duration() > 0.0 ? slip.distance / at.duration() : old[SlipMemory::size];
    return {{normal, slip.traction.t1, slip.traction.t2}, slip.slides ? Status::slip : Status::stick};
  }

  double keptWork(const PairStep& step) const { return step.work() - SlipMemory::lostWork(step); }
  static std::vector<OutputField> outputs() {
    std::vector<OutputField> outputs = SlipMemory::outputs();
    outputs.push_back({"slip_velocity", "length/time", "velocity of slip at the end of the load step"});
    return outputs;
  }
  void output(const PairStep& step, double* values) const {
    values[0] = SlipMemory::way(step.history);
    values[1] = step.history[SlipMemory::size];
  }

  double atRest, moving, velocity;
  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(RateDependentFriction)

}  // namespace harmos::laws
