#include "NewtonMarch.hpp"

#include <cmath>
#include <string>

#include <harmos/base/Error.hpp>

namespace harmos::benchmarks {
namespace {

constexpr int patience = 60;
// An iterative solver leaves this share of what Newton's method has left, and no less than this share of the target.
constexpr double forcing = 0.1, below = 0.3;

double norm(const std::vector<base::Vector3>& vectors) {
  double sum = 0.0;
  for (const base::Vector3& one : vectors) sum += base::dot(one, one);
  return std::sqrt(sum);
}

void extrapolate(const std::vector<base::Vector3>& before, std::vector<base::Vector3>& now) {
  for (std::size_t p = 0; p < now.size(); ++p) now[p] = 2.0 * now[p] - before[p];
}

}  // namespace

NewtonResult marchByNewton(JumpEquations& equations, const base::Matrix& amplitudes,
                           const std::vector<std::vector<double>>& frictions, double residual) {
  const std::size_t pairs = frictions.front().size();
  const JumpState zero{std::vector<base::Vector3>(pairs, base::Vector3{}),
                       std::vector<base::Vector3>(pairs, base::Vector3{})};
  JumpState state = zero, before = zero;  // before: end of the last load step
  NewtonResult result;
  std::vector<PairEquation> linear(pairs);
  for (int t = 0; t < amplitudes.numCols(); ++t) {
    equations.load(amplitudes[t]);
    const JumpState last = state;
    if (t > 1) {
      extrapolate(before.jump, state.jump);
      extrapolate(before.force, state.force);
    }
    before = last;
    double left = 1.0;
    for (int i = 0; left > residual; ++i) {
      if (i == patience) {
        throw base::Error("Newton's method has not converged at load step " + std::to_string(t + 1),
                          base::ExitCode::notConverged);
      }
      for (std::size_t p = 0; p < pairs; ++p) {
        const double scale = equations.scale(static_cast<int>(p));
        linear[p] = linearise(state.jump[p], state.force[p], before.jump[p], frictions[t][p], scale);
        if (t == 0 && i == 0) linear[p] = PairEquation{};
      }
      const double size = norm(state.force);
      equations.solve(linear, std::max(forcing * std::min(left, 1.0), below * residual) * size, state);
      ++result.iterations;
      std::vector<base::Vector3> violations;
      for (std::size_t p = 0; p < pairs; ++p) {
        violations.push_back(violation(state.jump[p], state.force[p], before.jump[p], frictions[t][p],
                                       equations.scale(static_cast<int>(p))));
      }
      left = norm(violations) / norm(state.force);
    }
    result.responses.push_back(equations.responses(state));
    double sum = 0.0;
    for (const base::Vector3& force : state.force) sum += force[0];
    result.pressureForce.push_back(sum);
  }
  return result;
}

}  // namespace harmos::benchmarks
