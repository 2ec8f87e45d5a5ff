#pragma once

#include <vector>

#include <harmos/latin/CorrectionTargets.hpp>
#include <harmos/latin/detail/StepSpace.hpp>

namespace harmos::latin {

/// Which load steps of a CausalCorrection go on, and what their residuals may hide. Slow modes are all but absent from
/// a residual, so that it counts over the smallest singular value of I - J in the space of the load step; hidden is a
/// share of the longest way. Not collective but for what it asks of spaces, and the same on every rank.
class UnfinishedSteps {
 public:
  /// Both must outlive it.
  UnfinishedSteps(const CorrectionTargets& targets, std::vector<StepSpace>& spaces)
      : targets_(targets), spaces_(spaces), isLeft_(spaces.size(), true) {}

  /// All load steps are unfinished; residuals up to `noise` are round-off.
  void start(double noise);
  /// Those of the load steps from `begin` on and before `end` that have not come to their end. The tangents of the
  /// others are released.
  std::vector<int> find(int begin, int end);
  /// Whether the last find() has named a load step.
  bool isLeft(int step) const { return isLeft_[step]; }
  /// Whether nothing but soft motions was left to be met then.
  bool goForSoftMotions() const { return goForSoft_; }
  /// Whether a load step has not come to its target.
  bool isAbove(int step) const { return targets_[step].residual > targets_.of(step); }
  /// Of unfinished load steps those that go on: in later corrections first those with too large a residual; when these
  /// have gone their ways, which all are measured by, those where most can be hidden.
  std::vector<int> foremost(const std::vector<int>& steps) const;
  /// The largest |R_t| / (s_t d) of all load steps, d the longest way of those before `end`.
  double hidden(int end) const;

 private:
  const CorrectionTargets& targets_;
  std::vector<StepSpace>& spaces_;
  std::vector<bool> isLeft_;
  double noise_ = 0.0;
  bool goForSoft_ = false;
};

}  // namespace harmos::latin
