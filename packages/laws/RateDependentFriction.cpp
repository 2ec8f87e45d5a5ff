#include <algorithm>
#include <cmath>

#include <harmos/laws/detail/BuiltIn.hpp>
#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/SlidingLaw.hpp>

namespace harmos::laws {
namespace {

// Newton's method from the left goes over one scale of the exponential at a step, and has 36 of them at most.
constexpr int mostSteps = 100;

/// Unilateral contact with friction that depends on the velocity of slip: mu(v) = mu_k + (mu_s - mu_k) exp(-v / v_c).
///
/// Where friction rises with the velocity the coefficient is that at the end of the load step: v = |slip - slip_old| /
/// dt is the root of a concave function that grows, so that the law is monotone under a pressure, and implicit Euler.
/// Where it falls, a load step would have several solutions as soon as dt < p (mu_s - mu_k) H / v_c, and without
/// inertia slip that is dragged at a constant velocity jumps: there the coefficient is that at the end of the load step
/// before, which loses no solution and gains none; what the present velocity would change in it is an output. History:
/// slip, its way [length], the velocity, and that which the coefficient belongs to, which stays in a load step without
/// duration [length/time]. Source: Bengisu, Akay (1994).
struct RateDependentFriction : SlidingLaw {
  static constexpr const char* name = "Rate-Dependent Friction";
  static constexpr int historySize = SlipMemory::size + 2;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with friction that falls, or rises, with the velocity of slip: mu = mu_k + (mu_s - mu_k) exp(-v / "
         "v_c), with v at the end of the load step where it rises, of the load step before where it falls. Time is "
         "that of the steps.")
        .source("Bengisu, Akay (1994)");
    p.equation("opening >= 0, t_n <= 0, their product 0; |t_t| <= mu |t_n|, mu = mu_k + (mu_s - mu_k) exp(-v / v_c)");
    p.number("Static Coefficient").example("0.4").unit("-").required().atLeast(0.0).doc("mu_s at rest.");
    p.number("Kinetic Coefficient").example("0.2").unit("-").required().atLeast(0.0).doc("mu_k at large velocities.");
    p.number("Velocity")
        .example("0.01")
        .unit("length/time")
        .required()
        .above(0.0)
        .doc("v_c, over which the coefficient changes.");
    p.number("Gap").unit("length").defaultValue(0.0).varying().doc(
        "Opening of the undeformed surfaces beyond their geometric distance; negative is interference.");
  }

  explicit RateDependentFriction(const input::Parameters& p)
      : atRest(p.number("Static Coefficient")),
        moving(p.number("Kinetic Coefficient")),
        velocity(p.number("Velocity")),
        gap(p.schedule("Gap")) {}

  double coefficient(double speed) const { return moving + (atRest - moving) * std::exp(-speed / velocity); }

  /// v > 0 where v dt + H p mu(v) = H trial [stress], for friction that rises and trial > p mu(0).
  double speedOnLine(double trial, double compliance, double pressure, double duration) const {
    double speed = 0.0;
    for (int step = 0; step < mostSteps; ++step) {
      const double rise = (moving - atRest) * std::exp(-speed / velocity);
      const double left = compliance * (trial - pressure * (moving - rise)) - speed * duration;
      const double next = speed + left / (duration + compliance * pressure * rise / velocity);
      if (!(next > speed)) break;
      speed = next;
    }
    return speed;
  }

  double shearLimit(const NodeContext& /*at*/, const base::Vector3& traction) const {
    return atRest * std::max(0.0, -traction[0]);
  }
  AdmissibleTractions admissibleTractions(int) const {
    return AdmissibleTractions::pressureAtMost(std::max(atRest, moving));
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double opening = line.freeJump[0] + at.gap + gap[at.step], duration = at.duration();
    double& speed = now[SlipMemory::size];
    double& speedOfCoefficient = now[SlipMemory::size + 1];
    speedOfCoefficient = old[duration > 0.0 ? SlipMemory::size : SlipMemory::size + 1];
    if (opening >= 0.0) {
      SlipMemory::keep(Tangential::of(line.freeJump), 0.0, old, now);
      speed = 0.0;
      return {{}, Status::open};
    }
    const double normal = contactTraction(opening, line.compliance);
    const Tangential oldSlip = SlipMemory::slip(old);
    if (moving > atRest && duration > 0.0) {
      const double trial = (Tangential::of(line.freeJump) - oldSlip).norm() / line.compliance;
      const bool slides = trial > -atRest * normal;
      speedOfCoefficient = slides ? speedOnLine(trial, line.compliance, -normal, duration) : 0.0;
    }
    const double limit = -coefficient(speedOfCoefficient) * normal;
    const SlipState slip = slipOnLine(line, 0.0, oldSlip, {limit, 0.0, 0.0});
    SlipMemory::keep(slip.slip, slip.distance, old, now);
    speed = duration > 0.0 ? slip.distance / duration : old[SlipMemory::size];
    return {{normal, slip.traction.t1, slip.traction.t2}, slip.slides ? Status::slip : Status::stick};
  }

  static std::vector<OutputField> outputs() {
    return outputsAnd({{"slip_velocity", "length/time", "velocity of slip at the end of the load step"},
                       {"coefficient_lag", "-", "coefficient at this velocity less the one that was taken"}});
  }
  void output(const PairStep& step, double* values) const {
    const double speed = step.history[SlipMemory::size];
    SlidingLaw::output(step, values);
    values[1] = speed;
    values[2] = coefficient(speed) - coefficient(step.history[SlipMemory::size + 1]);
  }

  double atRest, moving, velocity;
  input::Schedule gap;
};

}  // namespace

HARMOS_INTERFACE_LAW(RateDependentFriction)

}  // namespace harmos::laws
