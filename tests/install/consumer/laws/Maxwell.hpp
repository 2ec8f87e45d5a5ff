// Viscoelastic glue: a spring beside a spring and a dashpot in series (a standard solid), by implicit Euler. The rate
// comes from the duration of the load step. History: jump and traction of the dashpot's branch.
#pragma once

#include "Harmos.hpp"

struct Maxwell {
  static constexpr const char* name = "Outside Maxwell";
  static constexpr int historySize = 6;
  static constexpr Sides sides = Sides::two;
  static constexpr bool isSmooth = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Glue that relaxes: t = k delta + s, s' + s / tau = k_1 delta'.").source("Maxwell (1867)");
    p.number("Stiffness").unit("stress/length").required().atLeast(0.0).doc("k, after a long time.");
    p.number("Relaxing Stiffness").unit("stress/length").required().atLeast(0.0).doc("k_1, which is lost.");
    p.number("Relaxation Time").unit("time").required().above(0.0).doc("tau.");
  }
  explicit Maxwell(const input::Parameters& p)
      : stiffness(p.number("Stiffness")), relaxing(p.number("Relaxing Stiffness")), time(p.number("Relaxation Time")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double rest = 1.0 / (1.0 + at.duration() / time), slope = stiffness + rest * relaxing;
    LocalState state;
    for (std::size_t c = 0; c < 3; ++c) {
      const double kept = rest * (old[3 + c] - relaxing * old[c]);  // traction at delta = 0
      state.traction[c] = (kept + slope * line.freeJump[c]) / (1.0 + slope * line.compliance);
      now[c] = line.jump(state.traction)[c];
      now[3 + c] = kept + rest * relaxing * now[c];
    }
    return state;
  }

  double stiffness, relaxing, time;
};
