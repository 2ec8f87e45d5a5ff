#include <harmos/laws/detail/Rheology.hpp>

namespace harmos::laws {
namespace {

/// Maxwell's body along every axis: a spring and a dashpot in series, t = k (delta - v), t = eta dv/dt.
///
/// Implicit Euler: v = v_old + dt t / eta, which holds whatever the length dt of a load step. A jump that is held
/// relaxes with the time eta / k. History: v [length]. Source: Maxwell (1867).
struct MaxwellGlue : Rheology {
  static constexpr const char* name = "Maxwell Glue";

  static void describe(input::ParameterSpec& p) {
    p.summary(
         "Glue that creeps without end: a spring and a dashpot in series, normal and tangential. Under a jump that is "
         "held the traction falls by exp(-k t / eta). Time is that of the steps.")
        .source("Maxwell (1867); implicit Euler");
    p.equation("t = k (delta - v), t = eta dv/dt");
    Rheology::describe(p, "k of the spring, met at once.", "eta of the dashpot: eta / k is the time of relaxation.");
  }

  explicit MaxwellGlue(const input::Parameters& p) : Rheology(p) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    LocalState state;
    for (std::size_t i = 0; i < 3; ++i) {
      const double creep = at.duration() / viscosity[i];
      state.traction[i] = (line.freeJump[i] - old[i]) / (line.compliance + 1.0 / stiffness[i] + creep);
      now[i] = old[i] + creep * state.traction[i];
    }
    return state;
  }

  /// All but the traction times what the dashpot moves.
  double keptWork(const PairStep& step) const {
    double lost = 0.0;
    for (std::size_t i = 0; i < 3; ++i) lost += step.traction[i] * (step.history[i] - step.oldHistory[i]);
    return step.work() - lost;
  }
  double storedEnergy(const PairStep& step) const {
    double energy = 0.0;
    for (std::size_t i = 0; i < 3; ++i) energy += 0.5 * step.traction[i] * step.traction[i] / stiffness[i];
    return energy;
  }
  static std::vector<OutputField> outputs() { return {{"creep", "length", "length of the jump of the dashpots"}}; }
  void output(const PairStep& step, double* values) const {
    values[0] = base::norm({step.history[0], step.history[1], step.history[2]});
  }
};

}  // namespace

HARMOS_INTERFACE_LAW(MaxwellGlue)

}  // namespace harmos::laws
