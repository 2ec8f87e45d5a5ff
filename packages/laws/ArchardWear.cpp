#include <harmos/laws/detail/ContactTraction.hpp>
#include <harmos/laws/detail/StickingFriction.hpp>

namespace harmos::laws {
namespace {

/// Unilateral contact with friction whose surfaces wear off: the depth w opens the gap, delta_n + g + w >= 0, and grows
/// by K p times the way of slip.
///
/// The way is that of the load step before, the pressure that at the end of this one: so every load step has a graph
/// that is monotone along the normal, whatever it wears off, and the error in time is of first order. `Cycles` load
/// cycles like a load step wear off as many times as much. History: SlipMemory, w, and the way of the last load step
/// [length]. Source: Archard, Contact and rubbing of flat surfaces (1953).
struct ArchardWear {
  static constexpr const char* name = "Archard Wear";
  static constexpr int historySize = StickingFriction::historySize + 2;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Contact with Coulomb friction whose surfaces wear off: the depth grows by wear coefficient times pressure "
         "times "
         "way of slip in the load step before, as often as a load step stands for cycles.")
        .source("Archard (1953)");
    p.number("Wear Coefficient")
        .unit("1/stress")
        .required()
        .atLeast(0.0)
        .doc("K: depth of both surfaces together per pressure and way; K of Archard over the hardness.");
    p.number("Cycles").unit("-").defaultValue(1.0).atLeast(0.0).varying().doc(
        "How many cycles a load step stands for.");
    StickingFriction::describe(p);
  }

  explicit ArchardWear(const input::Parameters& p)
      : coefficient(p.number("Wear Coefficient")), cycles(p.schedule("Cycles")), shear(p) {}

  AdmissibleTractions admissibleTractions(int step) const {
    return AdmissibleTractions::pressure(shear.friction[step]);
  }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double* oldWear = old + StickingFriction::historySize;
    double* wear = now + StickingFriction::historySize;
    const double depth = at.duration() > 0.0 ? coefficient * cycles[at.step] * oldWear[1] : 0.0;  // by pressure
    const double opening = shear.freeOpening(line, at) + oldWear[0];
    const double pressure = -contactTraction(opening, line.compliance + depth);
    const LocalState state = shear.solve(line, at, opening >= 0.0, pressure, old, now);
    wear[0] = oldWear[0] + depth * pressure;
    wear[1] = at.duration() > 0.0 ? SlipMemory::way(now) - SlipMemory::way(old) : oldWear[1];
    return state;
  }

  double keptWork(const PairStep& step) const { return shear.keptWork(step); }
  double storedEnergy(const PairStep& step) const { return shear.storedEnergy(step.traction); }
  static std::vector<OutputField> outputs() {
    std::vector<OutputField> outputs = SlipMemory::outputs();
    outputs.push_back({"wear", "length", "depth that has worn off both surfaces together"});
    return outputs;
  }
  void output(const PairStep& step, double* values) const {
    values[0] = SlipMemory::way(step.history);
    values[1] = step.history[StickingFriction::historySize];
  }

  double coefficient;
  input::Schedule cycles;
  StickingFriction shear;
};

}  // namespace

HARMOS_INTERFACE_LAW(ArchardWear)

}  // namespace harmos::laws
