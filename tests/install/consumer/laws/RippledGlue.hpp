// Glue whose thickness varies over the surface: its stiffness is a field, computed where it is needed.
#pragma once

#include <cmath>

#include "Harmos.hpp"

struct RippledGlue {
  static constexpr const char* name = "Outside Fields";
  static constexpr int historySize = 0;
  static constexpr Sides sides = Sides::two;
  static constexpr bool isSmooth = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("A layer of glue around the z axis, whose thickness rises and falls twice on the way round.");
    p.number("Modulus").unit("stress").required().above(0.0).varying().doc("Of the glue.");
    p.number("Thickness").unit("length").required().above(0.0).doc("Mean thickness.");
    p.number("Ripple").unit("-").defaultValue(0.0).atLeast(0.0).below(1.0).doc("Relative amplitude, largest at y = 0.");
  }
  explicit RippledGlue(const input::Parameters& p)
      : modulus(p.schedule("Modulus")), thickness(p.number("Thickness")), ripple(p.number("Ripple")) {}

  LocalState solve(const LocalLine& line, const NodeContext& at, const double*, double*) const {
    const Vector3 place = at.position();
    const double here = thickness * (1.0 + ripple * std::cos(2.0 * std::atan2(place[1], place[0])));
    const double stiffness = modulus[at.step] / here;
    return {(stiffness / (1.0 + stiffness * line.compliance)) * line.freeJump, Status::bonded};
  }
  double storedEnergy(const PairStep& step) const { return 0.5 * dot(step.traction, step.jump); }

  input::Schedule modulus;
  double thickness, ripple;
};
