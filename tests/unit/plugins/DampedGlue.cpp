// A plugin as it should be: glue that loses a tenth of its stiffness in every load step in which it is stretched.
#include <algorithm>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/plugins/LawPlugin.hpp>

namespace {

using namespace harmos;

struct DampedGlue {
  static constexpr const char* name = "Damped Glue";
  static constexpr int historySize = 1;
  static constexpr laws::Sides sides = laws::Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Glue that gets tired.");
    p.number("Stiffness").unit("stress/length").required().above(0.0).varying().doc("At first.");
    p.number("Loss").unit("-").defaultValue(0.1).atLeast(0.0).doc("Of every load step that stretches it.");
  }

  explicit DampedGlue(const input::Parameters& p) : stiffness(p.schedule("Stiffness")), loss(p.number("Loss")) {
    if (loss >= 1.0) throw base::Error(p.where("Loss") + ": nothing would be left.", base::ExitCode::input);
  }

  laws::LocalState solve(const laws::LocalLine& line, const laws::NodeContext& at, const double* old,
                         double* now) const {
    const double k = stiffness[at.step] * std::pow(1.0 - loss, old[0]);
    laws::LocalState state;
    for (std::size_t c = 0; c < 3; ++c) state.traction[c] = k * line.freeJump[c] / (1.0 + k * line.compliance);
    now[0] = old[0] + (state.traction[0] > 0.0 ? 1.0 : 0.0);
    return state;
  }

  input::Schedule stiffness;
  double loss;
};

}  // namespace

HARMOS_LAW_PLUGIN(DampedGlue)
