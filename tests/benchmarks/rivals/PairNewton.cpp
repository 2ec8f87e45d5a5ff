#include "PairNewton.hpp"

#include <algorithm>
#include <cmath>

namespace harmos::benchmarks {
namespace {

// A trial friction beyond its limit by less than this share of it sticks: the slip matrix would be singular.
constexpr double edge = 1e-10;

/// The friction that a pair would carry if it stuck, and what it can.
struct Trial {
  Trial(const base::Vector3& jump, const base::Vector3& force, const base::Vector3& before, double friction,
        double scale)
      : pressure(force[0] - scale * jump[0]),
        limit(friction * std::max(0.0, pressure)),
        along{-force[1] + scale * (jump[1] - before[1]), -force[2] + scale * (jump[2] - before[2])},
        size(std::hypot(along[0], along[1])) {}

  double pressure;
  double limit;
  std::array<double, 2> along;
  double size;
};

}  // namespace

PairEquation linearise(const base::Vector3& jump, const base::Vector3& force, const base::Vector3& before,
                       double friction, double scale) {
  const Trial trial(jump, force, before, friction, scale);
  PairEquation result{};
  if (trial.pressure <= 0.0) {
    result.motion = PairEquation::Motion::open;
    return result;
  }
  if (friction > 0.0 && trial.size <= (1.0 + edge) * trial.limit) {
    result.motion = PairEquation::Motion::stick;
    result.held = {0.0, before[1], before[2]};
    return result;
  }
  result.motion = PairEquation::Motion::slip;
  result.from = {jump[1], jump[2]};
  if (trial.size == 0.0) return result;  // without friction

  // (I - M) q+ = M (c (w+ - w) - q) + mu p+ s, with the direction s, M = E (I - beta q s^T / max(limit, |q|)).
  const std::array<double, 2> q{-force[1], -force[2]};
  const std::array<double, 2> s{trial.along[0] / trial.size, trial.along[1] / trial.size};
  const double size = std::hypot(q[0], q[1]), share = trial.limit / trial.size;
  const double bound = std::max(trial.limit, size);
  const double cosine = size > 0.0 ? (q[0] * s[0] + q[1] * s[1]) / size : 0.0;
  const double beta = cosine < 0.0 ? 1.0 / (1.0 - cosine * std::min(size / trial.limit, 1.0)) : 1.0;
  std::array<std::array<double, 2>, 2> m{}, inverse{};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) m[i][j] = share * ((i == j ? 1.0 : 0.0) - beta * q[i] * s[j] / bound);
  }
  const double determinant = (1.0 - m[0][0]) * (1.0 - m[1][1]) - m[0][1] * m[1][0];
  inverse = {
      {{(1.0 - m[1][1]) / determinant, m[0][1] / determinant}, {m[1][0] / determinant, (1.0 - m[0][0]) / determinant}}};
  for (int i = 0; i < 2; ++i) {
    result.pull[i] = friction * (inverse[i][0] * s[0] + inverse[i][1] * s[1]);
    result.constant[i] = 0.0;
    for (int j = 0; j < 2; ++j) {
      const double product = inverse[i][0] * m[0][j] + inverse[i][1] * m[1][j];
      result.stiffness[i][j] = scale * product;
      result.constant[i] -= product * q[j];
    }
  }
  return result;
}

base::Vector3 violation(const base::Vector3& jump, const base::Vector3& force, const base::Vector3& before,
                        double friction, double scale) {
  const Trial trial(jump, force, before, friction, scale);
  const double cut = trial.size > trial.limit ? trial.limit / trial.size : 1.0;
  return {force[0] - std::max(0.0, trial.pressure), -force[1] - cut * trial.along[0], -force[2] - cut * trial.along[1]};
}

}  // namespace harmos::benchmarks
