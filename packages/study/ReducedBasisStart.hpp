#pragma once

#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/study/SolvedStates.hpp>

namespace harmos::study {

/// The start of a configuration: the least nonlinear residual over the span of solved states, found without a solve.
///
/// At each load step t, one after the other, alpha_t = V c with the columns of V: the step of the best of the nearest
/// states, the differences of the others to it, and its differences to its neighbouring steps. The image beta_t = Y c +
/// b_t is known, so c minimises |T(alpha_t) - alpha_t| in the state metric with local stages only, the history being
/// that of the steps before: Gauss-Newton with a line search, the Jacobian by differences through the local stage, so
/// that any law will do. For the displacement form. All calls are collective.
class ReducedBasisStart {
 public:
  explicit ReducedBasisStart(latin::FixedPoint& fixedPoint) : fixedPoint_(fixedPoint) {}

  /// Starts from at most `neighbours` states around the configuration whose laws are in the assembly. `offset`: b,
  /// the image of alpha = 0. `states` must not be empty.
  void find(const SolvedStates& states, const std::vector<double>& values, int neighbours, const base::Matrix& offset);

  /// alpha [stress], and T(alpha).
  const base::Matrix& state() const { return state_; }
  const base::Matrix& image() const { return image_; }
  /// |T(alpha) - alpha| in the state metric.
  double residual() const { return residual_; }
  /// ids of the configurations whose states were used, the one that the others are compared with first.
  const std::vector<int>& starts() const { return starts_; }
  /// Per load step, how residual (in the scale of the metric) and image change along the columns of V: what
  /// latin::AndersonAcceleration::seed() takes.
  const std::vector<base::Matrix>& residualTangents() const { return residualTangents_; }
  const std::vector<base::Matrix>& imageTangents() const { return imageTangents_; }

 private:
  void gather(const SolvedStates& states, const std::vector<double>& values, int neighbours,
              const base::Matrix& offset);
  void minimise(int step);
  /// Solves the local stage of a step; returns the squared norm of the scaled residual, which it leaves in `residual`.
  double solveStep(int step, const base::Matrix& alpha, const base::Matrix& beta, std::vector<double>& residual);
  void differentiate(int step, const base::Matrix& beta);

  latin::FixedPoint& fixedPoint_;
  std::vector<base::Matrix> columns_;  // V per load step
  std::vector<base::Matrix> linear_;   // Y = A V
  std::vector<base::Matrix> residualTangents_;
  std::vector<base::Matrix> imageTangents_;
  base::Matrix state_, beta_, image_;
  base::Matrix trialState_, trialBeta_, traction_;
  double residual_ = 0.0;
  std::vector<int> starts_;
};

}  // namespace harmos::study
