// A joint of sliders beside each other, each with its spring; elastic along the normal. History: where every slider is;
// how many there are is known at run time. The line is met by Newton's method, which Harmos brings.
#pragma once

#include <algorithm>
#include <vector>

#include <harmos/laws/NewtonOnLine.hpp>
#include <harmos/laws/NoIntersection.hpp>
#include "Harmos.hpp"

struct Iwan {
  static constexpr const char* name = "Outside Iwan";
  static constexpr Sides sides = Sides::two;

  static void describe(input::ParameterSpec& p) {
    p.summary("Springs with sliders of different strengths in parallel: microslip.").source("Iwan (1966)");
    p.number("Stiffness").unit("stress/length").required().above(0.0).doc("Of every spring, and of the normal.");
    p.numbers("Strengths").unit("stress").required().above(0.0).doc("Of the sliders.");
  }
  explicit Iwan(const input::Parameters& p) : stiffness(p.number("Stiffness")), strengths(p.numbers("Strengths")) {}

  int historySize() const { return 2 * static_cast<int>(strengths.size()); }

  /// Traction and slope at a jump; moves the sliders `now` along, where they are given.
  GraphPoint at(const Vector3& jump, const double* old, double* now = nullptr) const {
    GraphPoint point;
    point.traction[0] = stiffness * jump[0];
    point.slope[0][0] = stiffness;
    for (std::size_t i = 0; i < strengths.size(); ++i) {
      const Vector3 spring{0.0, jump[1] - old[2 * i], jump[2] - old[2 * i + 1]};
      const double pull = stiffness * norm(spring), share = pull > strengths[i] ? strengths[i] / pull : 1.0;
      point.traction = point.traction + share * stiffness * spring;
      for (std::size_t a = 1; a < 3; ++a) {
        for (std::size_t b = 1; b < 3; ++b) {
          const double along = share < 1.0 ? spring[a] * spring[b] / dot(spring, spring) : 0.0;
          point.slope[a][b] += share * stiffness * ((a == b ? 1.0 : 0.0) - along);
        }
        if (now != nullptr) now[2 * i + a - 1] = old[2 * i + a - 1] + (1.0 - share) * spring[a];
      }
    }
    return point;
  }

  LocalState solve(const LocalLine& line, const NodeContext& where, const double* old, double* now) const {
    const auto traction = newtonOnLine(
        line, [&](const Vector3& jump) { return at(jump, old).traction; },
        [&](const Vector3& jump) { return at(jump, old); });
    if (!traction) throw NoIntersection(line, where, "Newton's method comes to no end");
    at(line.jump(*traction), old, now);
    return {*traction, Status::bonded};
  }

  double stiffness;
  std::vector<double> strengths;
};
