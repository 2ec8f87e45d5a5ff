// A bilinear cohesive zone: irreversible damage under any mode, and contact by a penalty. History: the largest opening.
#pragma once

#include <algorithm>
#include <cmath>

#include "Harmos.hpp"

struct Cohesive {
  static constexpr const char* name = "Outside Cohesion";
  static constexpr int historySize = 1;
  static constexpr Sides sides = Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Bonds that soften linearly from their strength on, until the fracture energy is spent.")
        .source("Alfano, Crisfield (2001), with one mode");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("Before damage, and under pressure.");
    p.number("Strength").unit("stress").required().above(0.0).doc("Largest traction.");
    p.number("Fracture Energy").unit("stress*length").required().above(0.0).doc("Per area.");
  }
  static void check(const input::Parameters& p, input::ErrorList& errors) {
    if (2.0 * p.number("Fracture Energy") * p.number("Stiffness") > p.number("Strength") * p.number("Strength")) return;
    errors.add(p.where("Stiffness"), "the bond would fail before it reaches its strength.",
               "Take more than Strength^2 / (2 Fracture Energy).");
  }

  explicit Cohesive(const input::Parameters& p)
      : stiffness(p.number("Stiffness")),
        strength(p.number("Strength")),
        first(strength / stiffness),
        last(2.0 * p.number("Fracture Energy") / strength) {}

  double lowestSlope() const { return -strength / (last - first); }
  /// Traction over opening when the largest opening so far is `opening`.
  double secant(double opening) const {
    if (opening <= first) return stiffness;
    return strength * std::max(0.0, (last - opening) / (last - first)) / opening;
  }

  LocalState solve(const LocalLine& line, const NodeContext&, const double* old, double* now) const {
    const double h = line.compliance;
    const bool isPressed = line.freeJump[0] < 0.0;
    const double pull = isPressed ? tangentialNorm(line.freeJump) : norm(line.freeJump);
    const double softening = strength / (last - first);
    double opening = pull / (1.0 + h * secant(old[0]));
    if (opening > std::max(old[0], first)) {
      opening = h * softening < 1.0 ? (pull - h * softening * last) / (1.0 - h * softening) : pull;
      if (opening > last) opening = pull;
    }
    now[0] = std::max(old[0], opening);
    const double k = secant(now[0]), pressed = isPressed ? stiffness : k;
    const Vector3& f = line.freeJump;
    return {{pressed * f[0] / (1.0 + h * pressed), k * f[1] / (1.0 + h * k), k * f[2] / (1.0 + h * k)},
            now[0] >= last ? Status::broken : Status::bonded};
  }

  double stiffness, strength, first, last;
};
