#include <harmos/latin/detail/FaintMotions.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace harmos::latin {
namespace {

// Resistance by springs of boundaries below which a space may lack a motion.
constexpr double softByBoundaries = 1e-3;

}  // namespace

void FaintMotions::add(std::vector<double> v, std::vector<double> y, std::vector<double> u) {
  std::vector<double> square{0.0};
  for (std::size_t row = 0; row < u.size(); ++row) {
    square[0] += metric_->scale()[row] * metric_->scale()[row] * u[row] * u[row];
  }
  metric_->sum(square);
  for (double& x : u) x /= square[0];
  motions_.push_back({std::move(v), std::move(y), std::move(u)});
}

double FaintMotions::move(const double* residual, double* alpha, double* beta) const {
  const std::vector<double>& scale = metric_->scale();
  std::vector<double> ways(motions_.size(), 0.0);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      ways[i] += scale[row] * scale[row] * motions_[i].change[row] * residual[row];
    }
  }
  metric_->sum(ways);
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    for (std::size_t row = 0; row < scale.size(); ++row) {
      alpha[row] += ways[i] * motions_[i].state[row];
      beta[row] += ways[i] * motions_[i].image[row];
    }
  }
  // The v are orthonormal.
  return std::sqrt(std::inner_product(ways.begin(), ways.end(), ways.begin(), 0.0));
}

FaintMotions motionsBesideSpace(const SoftMotions& softMotions, const PairTangents& tangents, const StateMetric& metric,
                                const std::function<std::vector<double>(const double* v)>& imageOf) {
  FaintMotions result(metric);
  for (const SoftMotions::Motion& motion : softMotions.find(tangents, SoftMotions::hardest)) {
    std::vector<double> v = softMotions.state(motion);
    if (motion.resistance < SoftMotions::lost || softMotions.isLeftToLaws(motion)) {
      result.add(std::move(v), softMotions.image(motion), softMotions.change(tangents, motion));
    } else if (motion.resistance <= softByBoundaries) {
      // What springs do to bodies that are not rigid is as large as what they do to rigid ones.
      std::vector<double> y = imageOf(v.data());
      const int rows = static_cast<int>(v.size());
      base::Matrix image(rows, 1), traction(rows, 1);
      std::copy(y.begin(), y.end(), image[0]);
      tangents.apply(image, traction);
      std::vector<double> u(v);
      for (int row = 0; row < rows; ++row) u[row] += y[row] - 2.0 * traction(row, 0);
      result.add(std::move(v), std::move(y), std::move(u));
    }
  }
  return result;
}

}  // namespace harmos::latin
