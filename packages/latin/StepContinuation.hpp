#pragma once

#include <functional>

#include <harmos/latin/StepNewton.hpp>

namespace harmos::latin {

/// Brings a load step on in parts, where laws soften: the loads of a part are interpolated between those of the load
/// step before and its own, and every part is solved by Newton's method from where the parts before lead.
///
/// A crack that runs along an interface changes from pair to pair; a whole load step of it lies too far away for
/// Newton's method. Loads enter beta of the linear stage linearly, so that the directions of StepNewton serve all
/// parts. All parts have the history that the load step before has left: what is found at the end solves the load step
/// itself, and lies on the branch of solutions that grows from the load step before. Parts that do not come to an end
/// are tried with whole steps of Newton's method, and halved; where a part has become too small, the branch turns back:
/// the structure snaps. Laws and gaps that change with the load step are those of its end. Displacement form, with the
/// local stage PointwiseLocalStage.
class StepContinuation {
 public:
  /// What has become of a load step.
  struct Result {
    bool isReached = false;
    int parts = 0;       ///< that were solved
    double share = 0.0;  ///< of the load step, at the last of them
  };

  /// A part that would be smaller than this share of its load step is not tried.
  static constexpr double leastPart = 1.0 / 512.0;

  /// Both must outlive it.
  StepContinuation(FixedPoint& fixedPoint, StepNewton& newton) : fixedPoint_(fixedPoint), newton_(newton) {}

  /// A state that the way to `before` came from, and how many times as far this load step is expected to go.
  struct Way {
    base::Matrix from;   ///< one column
    double times = 0.0;  ///< 0: nothing is expected, and `from` is not looked at
  };

  /// Collective, `step` selected. From `before`, the solution of the load step before (0 of the first one), leaves in
  /// `state` that of this one, |R| <= target; or, where that cannot be reached, the last one on the way. `mustStop`,
  /// which may be empty, is asked on every rank. No iterate is valid afterwards. Throws base::Error as
  /// LocalStage::solve(). Where loads are found, and their size is not known before, it is `share` of |f^| at the end
  /// of every part, but no less than `target`.
  Result solve(int step, const base::Matrix& before, const Way& way, base::Matrix& state, double target, double share,
               const std::function<bool()>& mustStop);

 private:
  /// One part by Newton's method, with steps that are damped, or else whole.
  bool solveBoth(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta, double target,
                 const std::function<bool()>& mustStop);
  /// One part, with `offset` added to beta. See solve() for the others.
  bool solvePart(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta, double target, double share,
                 const std::function<bool()>& mustStop);
  /// |f^| of a state.
  double forceOf(const base::Matrix& offset, const base::Matrix& beta) const;

  FixedPoint& fixedPoint_;
  StepNewton& newton_;
};

}  // namespace harmos::latin
