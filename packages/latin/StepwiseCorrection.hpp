#pragma once

#include <functional>
#include <vector>

#include <harmos/latin/StepNewton.hpp>

namespace harmos::latin {

/// Corrects a state towards alpha = T(alpha), one load step after the other, each by Newton's method with the history
/// that the corrected steps before it have left.
///
/// A load step with laws that soften is followed in parts where Newton's method does not lead to its end, or settles;
/// where it does, the state also goes along soft motions of the parts, and is not reached if round-off asks for them.
/// Unlike a CausalCorrection it takes steps that make |R| greater, which kinks of the laws may ask for, and gives all
/// load steps the directions of all. Displacement form, with the local stage PointwiseLocalStage.
class StepwiseCorrection {
 public:
  /// What a correction has come to.
  struct Result {
    bool isReached = false;  ///< by every load step
    /// The least over the load steps of the singular values of I - J in the space of directions.
    double smallestSingularValue = 1.0;
  };

  /// Both must outlive it.
  StepwiseCorrection(FixedPoint& fixedPoint, StepNewton& newton) : fixedPoint_(fixedPoint), newton_(newton) {}

  /// Collective, all load steps selected. Moves `alpha`, whose iterate is given, until every load step has |R| <=
  /// `targets`, its own, or where that cannot be reached `target`, or one cannot reach that, or the linear stage has
  /// reached `stageLimit` stages. No iterate is valid afterwards. Throws base::Error as LocalStage::solve().
  Result correct(const Iterate& iterate, base::Matrix& alpha, double target, const std::vector<double>& targets,
                 int stageLimit);

 private:
  /// Where laws soften: from the load step before, which is corrected, as StepContinuation does, or else where the
  /// joint has snapped, from the state itself to where it comes to rest; false where neither leads there.
  bool findAnotherWay(int step, const base::Matrix& alpha, base::Matrix& state, double target,
                      const std::function<bool()>& mustStop);

  FixedPoint& fixedPoint_;
  StepNewton& newton_;
};

}  // namespace harmos::latin
