#include <algorithm>

#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/StickingFriction.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with friction whose surfaces wear off: the depth w opens the gap, delta_n + g + w >= 0, and grows
/// by K p times the way of slip.
///
/// Pressure is that at the end of the load step; the way in it is foreseen from the velocity at its beginning. What has
/// been slid and not worn off yet, less what was worn off and not slid, is owed, and is worn off in the next load step
/// as well, under the pressure of that: so every load step has a graph that is monotone along the normal, more wears
/// off where the pressure is higher, which evens it out whatever the velocity does, and steady slip lags by nothing
/// from its second load step on. (With the way of the load step itself the pressure would fall with it, and friction
/// with the pressure: more than one solution where K p mu > 1. A depth that is owed would come from a pressure that is
/// no more, and a stiff part whose velocity grows would bring it to few of its points.) `Cycles` load cycles like a
/// load step wear off as many times as much. History: SlipMemory, w [length], what is owed of the way times cycles
/// [length], velocity [length/time]. Source: Archard, Contact and rubbing of flat surfaces (1953).
struct ArchardWear : StickingFriction {
  static constexpr const char* name = "Archard Wear";
  static constexpr int historySize = SlipMemory::size + 3;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with Coulomb friction whose surfaces wear off: the depth grows by wear coefficient times pressure "
         "times way of slip, as often as a load step stands for cycles.")
        .source("Archard (1953)");
    p.equation(
        "opening + w >= 0, t_n <= 0, their product 0; |t_t| <= mu p; w grows by K p |s - s_old| times Cycles in a load "
        "step");
    p.number("Wear Coefficient")
        .example("1e-6")
        .unit("1/stress")
        .required()
        .atLeast(0.0)
        .doc("K: depth of both surfaces together per pressure and way; K of Archard over the hardness.");
    p.number("Cycles").unit("-").defaultValue(1.0).atLeast(0.0).varying().doc(
        "How many cycles a load step stands for.");
    StickingFriction::describe(p);
  }

  explicit ArchardWear(const input::Parameters& p)
      : StickingFriction(p), coefficient(p.number("Wear Coefficient")), cycles(p.schedule("Cycles")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double *oldWear = old + SlipMemory::size, duration = at.duration();
    double* wear = now + SlipMemory::size;
    const bool goesOn = duration > 0.0;
    const double worn = goesOn ? std::max(0.0, oldWear[1] + cycles[at.step] * oldWear[2] * duration) : 0.0;
    const double opening = freeOpening(line, at) + oldWear[0];
    const double pressure = -contactTraction(opening, line.compliance + coefficient * worn);
    const LocalState state = slideUnder(line, at, opening >= 0.0, pressure, old, now);
    const double way = SlipMemory::way(now) - SlipMemory::way(old);
    wear[0] = oldWear[0] + coefficient * worn * pressure;
    wear[1] = oldWear[1] + cycles[at.step] * way - (pressure > 0.0 ? worn : 0.0);
    wear[2] = goesOn ? way / duration : oldWear[2];
    return state;
  }

  /// All but what friction takes, and the pressure that follows the surfaces as they wear off.
  static double keptWork(const PairStep& step) {
    const double *old = step.oldHistory + SlipMemory::size, *now = step.history + SlipMemory::size;
    return SlidingLaw::keptWork(step) + step.traction[0] * (now[0] - old[0]);
  }
  double storedEnergy(const PairStep& step) const { return shearEnergy(step.traction); }
  static std::vector<OutputField> outputs() {
    return outputsAnd({{"wear", "length", "depth that has worn off both surfaces together"},
                       {"wear_lag", "length", "depth that the next load step still has to wear off for this one"}});
  }
  void output(const PairStep& step, double* values) const {
    SlidingLaw::output(step, values);
    values[1] = step.history[SlipMemory::size];
    values[2] = -coefficient * step.traction[0] * step.history[SlipMemory::size + 1];
  }

  double coefficient;
  input::Schedule cycles;
};

}  // namespace

HARMOS_INTERFACE_LAW(ArchardWear)

}  // namespace harmos::laws
