#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/InterfaceLines.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/parametric/SolvedStates.hpp>

namespace harmos::parametric {

/// The start of a configuration: the least nonlinear residual over the span of solved states, found without a solve;
/// and along the way of its iteration, over what that has solved besides.
///
/// At each load step t, one after the other, alpha_t = V c with the columns of V: the step of the best of the nearest
/// states, the differences of the others to it, its differences to its two neighbouring steps, and what the iteration
/// added to the start of the step before. The image beta_t = Y c + b_t is known, so c minimises |T(alpha_t) - alpha_t|
/// in the state metric with local stages only: Gauss-Newton with a line search from the c of the step before, the
/// Jacobian by the tangents of the pairs (latin::PairTangents), so that any law will do. For the displacement form. All
/// calls are collective.
class ReducedBasisStart {
 public:
  /// Columns of V at most, beyond one per state and per change that is remembered.
  static constexpr int furtherColumns = 3;

  /// `local`: the local stage that is asked, of `fixedPoint`. Both must outlive it. `changes` are remembered at most.
  ReducedBasisStart(const latin::FixedPoint& fixedPoint, latin::PointwiseLocalStage& local, int changes);

  /// Chooses at most `neighbours` states around the configuration whose laws are in the assembly. `offset`: b, the
  /// image of alpha = 0. `states` must not be empty, `offset` must stay as it is. Selects all load steps of the local
  /// stage, which follow on the unloaded state.
  void begin(const SolvedStates& states, const std::vector<double>& values, int neighbours, const base::Matrix& offset);
  /// ids of the configurations whose states are used, the one that the others are compared with first.
  const std::vector<int>& starts() const { return starts_; }
  /// Of the first of them: root mean square over the load steps of |f^| in the state metric.
  double traction() const { return traction_; }
  /// What its indicators are measured by [force], as it was given to SolvedStates::add().
  const std::vector<double>& forces() const { return forces_; }

  /// The start of a load step that alone is selected, after those before it; ends when |T(alpha) - alpha| in the state
  /// metric is at most `tolerance`.
  void find(int step, double tolerance);
  /// alpha [stress] and its image beta under the linear stage, one column.
  const base::Matrix& state() const { return state_; }
  /// The latter [stress].
  const base::Matrix& beta() const { return beta_; }
  /// Whether find() needed the tangents; else differentiate() provides them.
  bool hasTangents() const { return hasTangents_; }
  /// Collective. Makes V the columns of a load step without looking for its start: for a later march through it.
  void gather(int step);
  /// Keeps a change of alpha [stress] that has been solved for since begin(), and its image under A [stress], one
  /// column each, of whatever load step: A is the same for all. Only the last ones are kept.
  void remember(const base::Matrix& change, const base::Matrix& image);
  /// Forgets all changes, and leaves them out of V.
  void forget();
  /// Collective. Adds to V, the columns of a load step, the changes that are remembered, and goes from alpha and its
  /// image beta [stress], one column each, along V to less residual where there is less; ends as find() does. state()
  /// and beta() are then where it has come to.
  void improve(const base::Matrix& alpha, const base::Matrix& beta, double tolerance);
  /// Collective. Computes the tangents along V at the state whose beta the local stage has solved last.
  void differentiate();
  /// How residual (in the scale of the metric) and image change along the columns of V: what
  /// latin::AndersonAcceleration::seed() takes.
  const base::Matrix& residualTangents() const { return residualTangents_; }
  /// The latter [stress], rows of the layout x columns of V.
  const base::Matrix& imageTangents() const { return imageTangents_; }

  /// To be told what the iteration has made of the load step: alpha and beta, one column.
  void settle(int step, const base::Matrix& state, const base::Matrix& beta);

 private:
  /// Solves the local stage; returns the squared norm of the scaled residual, which it leaves in `residual`.
  double evaluate(const base::Matrix& alpha, const base::Matrix& beta, std::vector<double>& residual);
  void minimise(double tolerance);
  /// c of the least |residual + tangents c|.
  std::vector<double> leastSquares() const;
  void addChanges();
  /// state_ + length V c, and its image.
  void combine(const std::vector<double>& c, double length);
  void takeTrial(double length, const std::vector<double>& c);

  const latin::FixedPoint& fixedPoint_;
  latin::PointwiseLocalStage& local_;
  latin::InterfaceLines lines_;
  latin::PairTangents tangents_;
  const base::Matrix* offset_ = nullptr;
  std::vector<std::shared_ptr<const SolvedStates::State>> states_;  // the origin of the differences first
  base::Matrix columns_, linear_;                                   // V, and Y = A V
  int ownColumns_ = 0;                                              // of V, without changes
  int mostChanges_;
  base::Matrix changes_, changesLinear_;      // the last ones, and A times them
  int changesSolved_ = 0;                     // since begin()
  base::Matrix remainder_, remainderLinear_;  // what the iteration added to the start of the step before
  std::vector<double> weights_;               // c in all; then that to begin the next step with
  base::Matrix residualTangents_;
  base::Matrix imageTangents_;
  bool hasTangents_ = false;
  base::Matrix state_, beta_, hatted_;
  base::Matrix trialState_, trialBeta_;
  std::vector<double> residual_, trialResidual_;  // scaled
  double traction_ = 0.0;
  std::vector<double> forces_;
  std::vector<int> starts_;
};

}  // namespace harmos::parametric
