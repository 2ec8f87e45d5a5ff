#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/NewtonCorrection.hpp>
#include <harmos/latin/Snapshot.hpp>
#include <harmos/latin/StepNewton.hpp>

namespace harmos::latin {

class CausalCorrection;

/// Estimates the true error of a state by two successive corrections and claims accuracy only when they agree.
///
/// From alpha, a first correction (CausalCorrection) moves to a1. A second one, in the same spaces and further
/// directions, estimates the error of a1: e2 = |q(a1) - q(a2)| for every promised quantity q. With kappa = max e2 / max
/// e1 the estimate is E, the largest e2 / (1 - kappa) of all load steps, in which kappa counts as 0.6 at least where
/// the second correction leaves 0.3 of the residual of the load step, and as 1 - 4/7 (1 - r) where it leaves r > 0.3;
/// of corrections that hardly contract it counts as 0.8, and e2 is added. It is claimed when E <= accuracy, e1 <= 0.3,
/// kappa <= 1 (or e2 is a tenth of the accuracy), both corrections reduced the largest residual of a load step to 0.2
/// and 0.6 and hide no more than their way in it (or what is hidden is a tenth of the accuracy), no load step keeps
/// more than 0.95 of its own in the second one, the gap between the two fields of the iteration is below ten times the
/// accuracy, and no body was thrown far away without being held there. What is left then is a2, within E as well, whose
/// fields are at hand. If E is too large, a2 takes the place of a1 and is corrected once more.
///
/// Where a causal correction stagnates, the attempt ends without a claim; where one does in a later attempt, or laws
/// soften, and from the beginning where the way there needed StepNewton, a StepwiseCorrection takes its place. Where
/// laws soften and a stepwise correction does not come to the residual that its images promise, the round-off of these
/// is measured, and a residual within it counts as none. In the velocity form corrections are a NewtonCorrection each:
/// they start anew each time and need relaxed iterations after each, which smooth their rough residual, so that a1 is
/// left; they must reduce the residual to 0.15, and kappa counts as what they leave, instead of 0.6, at least.
/// ErrorEstimate has what follows from corrections alone.
///
/// The gap is max(|f - f^| / |f^|, |w - w^| / |w|): with f - f^ = -k (w - w^) one of them is large for any k far from
/// the stiffness of the bodies, so an absurd k cannot hide behind small changes.
class Certificate {
 public:
  /// What came of an attempt.
  struct Result {
    bool claimed = false;              ///< E is within the accuracy, and all else that a claim needs is given
    bool conclusive = false;           ///< both corrections could be computed; `estimates` holds E
    std::vector<double> estimates;     ///< as Snapshot::distance: responses, force field, displacement field
    double contraction = 1.0;          ///< kappa [-]
    bool stagnated = false;            ///< a causal correction did not reduce the residual as much as it must
    bool isRoundOff = false;           ///< what the last correction has left counts as none, as measured round-off
    const Iterate* iterate = nullptr;  ///< where claimed, of the state that is left, if its image is at hand
  };

  /// Of one run, from its beginning on. All arguments must outlive it. `accuracy`: relative [-].
  Certificate(FixedPoint& fixedPoint, StepNewton& newton, const std::vector<std::shared_ptr<const Response>>& responses,
              double accuracy);
  ~Certificate();
  Certificate(const Certificate&) = delete;
  Certificate& operator=(const Certificate&) = delete;

  /// Collective. `image` = T(alpha), and `iterate` is that of alpha, at the beginning. Leaves in `alpha` a state that
  /// is no farther away than the estimates say, or the best one to go on from, and in `image` that of some state, at
  /// most at `stageLimit` linear stages in all, counted as LinearStage::stages(). Throws base::Error as Snapshot.
  Result attempt(const Iterate& iterate, base::Matrix& alpha, base::Matrix& image, int stageLimit);

 private:
  /// How a state is corrected.
  enum class Kind { causal, stepwise, newton };
  /// What became of the correction of a state, which is corrected in place, or left as it was.
  struct Correction {
    double reduction = 1.0;            // of the residual
    std::vector<double> shares;        // that load steps keep of it, as CausalCorrection::Result
    bool isReduced = false;            // the residual, as much as an estimate needs
    double hidden = 0.0;               // as NewtonCorrection::Result::hidden
    bool isRoundOff = false;           // what is left is within the round-off that was measured
    const Iterate* iterate = nullptr;  // of the corrected state, where its image is known
  };
  Result attemptOnce(Kind kind, const Iterate& iterate, base::Matrix& state, base::Matrix& image, int stageLimit);
  /// Number `count` of this attempt. May replace the image by that of the corrected state.
  Correction correctCausally(const Iterate& iterate, base::Matrix& state, base::Matrix& image, int count, int stages);
  /// Replaces the image by that of the corrected state.
  Correction correctStepwise(const Iterate& iterate, base::Matrix& state, base::Matrix& image, int count,
                             int stageLimit);
  /// `isClose`: the correction before went hardly anywhere.
  Correction correctByNewton(const Iterate& iterate, base::Matrix& state, const base::Matrix& image, bool isClose,
                             int stages);
  /// What is seen of a state whose tractions are shared (FixedPoint::shareTractions()). The state itself, its image and
  /// its iterate stay those that were found: shared ones keep to the laws no better than to a part of the accuracy, and
  /// a correction would begin with the residual of that again.
  Snapshot lookAtShared(const Iterate& iterate, base::Matrix& state, base::Matrix& image);
  /// Relaxed iterations of `state`, whose image is given; returns its iterate.
  const Iterate& smooth(base::Matrix& state, base::Matrix& image);

  FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
  double accuracy_;
  StepNewton& stepNewton_;
  NewtonCorrection newton_;
  std::unique_ptr<CausalCorrection> causal_;  // displacement form
  bool hasStagnated_ = false;                 // a causal correction, before
  double noise_ = 0.0;                        // of images, where this attempt has measured it and laws do not soften
};

/// The gap that a claim allows, over the accuracy.
inline constexpr double allowedGap = 10.0;

/// Of residuals that count as round-off, which does not contract: errors that they may stand for.
inline constexpr double errorOfRoundOff = 5.0;

/// The gap between the fields of both stages, see Certificate. Collective.
double fieldGap(const Iterate& state);

}  // namespace harmos::latin
