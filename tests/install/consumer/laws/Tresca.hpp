// An elastic layer that slides at a given shear traction, whatever the pressure. History: the slip.
#pragma once

#include "Harmos.hpp"

struct Tresca {
  static constexpr const char* name = "Outside Tresca";
  static constexpr int historySize = 2;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("An elastic layer that slides at its shear strength, and never opens.").source("Tresca (1864)");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("Of the layer, in all directions.");
    p.number("Shear Strength").unit("stress").required().atLeast(0.0).varying().doc("Traction of sliding.");
  }
  explicit Tresca(const input::Parameters& p)
      : stiffness(p.number("Stiffness")), strength(p.schedule("Shear Strength")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const double k = stiffness / (1.0 + stiffness * line.compliance);
    Vector3 t{k * line.freeJump[0], k * (line.freeJump[1] - old[0]), k * (line.freeJump[2] - old[1])};
    const double trial = tangentialNorm(t), limit = strength[at.step];
    const bool slides = trial > limit;
    for (std::size_t c = 1; c < 3; ++c) {
      if (slides) t[c] *= limit / trial;
      now[c - 1] = slides ? line.jump(t)[c] - t[c] / stiffness : old[c - 1];
    }
    return {t, slides ? Status::slip : Status::stick};
  }

  /// Of the springs.
  double storedEnergy(const PairStep& s) const { return 0.5 * dot(s.traction, s.traction) / stiffness; }
  /// Of the springs; what the slip takes is lost.
  double keptWork(const PairStep& s) const {
    double kept = s.traction[0] * (s.jump[0] - s.oldJump[0]);
    for (std::size_t c = 1; c < 3; ++c) {
      kept += s.traction[c] * ((s.jump[c] - s.history[c - 1]) - (s.oldJump[c] - s.oldHistory[c - 1]));
    }
    return kept;
  }

  double stiffness;
  input::Schedule strength;
};
