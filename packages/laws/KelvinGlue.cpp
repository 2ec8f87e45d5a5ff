#include <harmos/laws/detail/Rheology.hpp>

namespace harmos::laws {
namespace {

/// Kelvin's and Voigt's body along every axis: a spring and a dashpot in parallel, t = k delta + eta d(delta)/dt.
///
/// Implicit Euler over the load step. A load that is held creeps to t / k with the time eta / k; in a load step without
/// duration nothing moves. History: delta at its end [length]. Source: Thomson (1865), Voigt (1892).
struct KelvinGlue : Rheology {
  static constexpr const char* name = "Kelvin Glue";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Glue that creeps to an end: a spring and a dashpot in parallel, normal and tangential. Under a load that is "
         "held the jump grows like 1 - exp(-k t / eta). Time is that of the steps.")
        .source("Thomson (1865), Voigt (1892); implicit Euler");
    p.equation("t = k delta + eta d(delta)/dt");
    Rheology::describe(p, "k of the spring, which carries in the end.",
                       "eta of the dashpot: eta / k is the time of retardation.");
  }

  explicit KelvinGlue(const input::Parameters& p) : Rheology(p) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    LocalState state;
    const double time = at.duration();
    for (std::size_t i = 0; i < 3; ++i) {
      const double k = stiffness[i], eta = viscosity[i];
      state.traction[i] = (k * time * line.freeJump[i] + eta * (line.freeJump[i] - old[i])) /
                          (time + line.compliance * (k * time + eta));
      now[i] = line.freeJump[i] - line.compliance * state.traction[i];
    }
    return state;
  }

  /// All but what the dashpots take.
  double keptWork(const PairStep& step) const {
    double kept = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      kept += stiffness[i] * step.jump[i] * (step.jump[i] - step.oldJump[i]);
    }
    return kept;
  }
  double storedEnergy(const PairStep& step) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < 3; ++i) energy += 0.5 * stiffness[i] * step.jump[i] * step.jump[i];
    return energy;
  }
};

}  // namespace

HARMOS_INTERFACE_LAW(KelvinGlue)

}  // namespace harmos::laws
