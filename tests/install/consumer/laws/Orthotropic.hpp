// Contact with a friction that depends on the direction: an ellipse of tractions along and across a direction of space,
// to which sliding is normal. History: tangential jump of the step before, along these axes.
#pragma once

#include <algorithm>
#include <cmath>

#include "Harmos.hpp"

struct Orthotropic {
  static constexpr const char* name = "Outside Orthotropic";
  static constexpr int historySize = 2;
  static constexpr Sides sides = Sides::any;
  static constexpr bool dissipates = true;

  static void describe(input::ParameterSpec& p) {
    p.summary("Unilateral contact with orthotropic friction.").source("Michalowski, Mroz (1978)");
    p.number("Friction Along").unit("-").required().above(0.0).doc("Of sliding along the direction.");
    p.number("Friction Across").unit("-").required().above(0.0).doc("Of sliding across it.");
    p.number("Gap").unit("length").defaultValue(0.0).doc("Opening beyond the distance of the surfaces.");
    p.numbers("Axis").unit("-").required().doc("Components in space, such as {1, 0, 0} along the grooves.");
  }
  explicit Orthotropic(const input::Parameters& p)
      : along(p.number("Friction Along")), across(p.number("Friction Across")), gap(p.number("Gap")) {
    const std::vector<double>& d = p.numbers("Axis");
    if (d.size() != 3)
      throw harmos::base::Error(p.where("Axis") + ": a direction has three numbers.", harmos::base::ExitCode::input);
    direction = {d[0], d[1], d[2]};
  }
  AdmissibleTractions admissibleTractions(int) const { return AdmissibleTractions::pressure(std::max(along, across)); }
  double keptWork(const PairStep& s) const { return s.traction[0] * (s.jump[0] - s.oldJump[0]); }

  LocalState solve(const LocalLine& line, const NodeContext& at, const double* old, double* now) const {
    const Vector3 d = toFrame(at.frame(), direction);
    const double size = std::hypot(d[1], d[2]), c = size > 0.0 ? d[1] / size : 1.0, s = size > 0.0 ? d[2] / size : 0.0;
    const double h = line.compliance, opening = line.freeJump[0] + at.gap + gap, pressure = std::max(0.0, -opening / h);
    const double u = c * line.freeJump[1] + s * line.freeJump[2], v = c * line.freeJump[2] - s * line.freeJump[1];
    double a = (u - old[0]) / h, b = (v - old[1]) / h;  // tractions that stick
    const double p = along * pressure, q = across * pressure;
    bool slides = a * a * q * q + b * b * p * p > p * p * q * q;
    if (slides && pressure > 0.0) {
      double l = 0.0;
      for (int i = 0; i < 100; ++i) {
        const double x = a * p / (p * p + l), y = b * q / (q * q + l), left = x * x + y * y - 1.0;
        const double move = left / (2.0 * (x * x / (p * p + l) + y * y / (q * q + l)));
        l += move;
        if (std::abs(move) <= 1e-16 * (l + p * q)) break;
      }
      a *= p * p / (p * p + l), b *= q * q / (q * q + l);
    }
    if (!(pressure > 0.0)) a = pressure * a, b = pressure * b;
    now[0] = u - h * a, now[1] = v - h * b;
    return {{opening < 0.0 ? opening / h : opening * 0.0, c * a - s * b, s * a + c * b},
            pressure > 0.0 ? (slides ? Status::slip : Status::stick) : Status::open};
  }

  double along, across, gap;
  Vector3 direction{};
};
