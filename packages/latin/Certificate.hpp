#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/NewtonCorrection.hpp>
#include <harmos/latin/Snapshot.hpp>

namespace harmos::latin {

/// Estimates the true error of a state by two successive Newton corrections and claims accuracy only when they agree.
///
/// From alpha, a first correction d1 moves to a1 = alpha + d1, smoothed by relaxed iterations (a fresh correction
/// leaves a rough residual). A second one, with the tangent rebuilt, estimates the error of a1: e2 = |q(a1) - q(a1 +
/// d2)| for every promised quantity q. With kappa = max e2 / max e1 the estimate is E = e2 / (1 - kappa). It is claimed
/// when E <= accuracy, e1 <= 0.3, kappa <= 1 (or e2 is a tenth of the accuracy), both Krylov solves reduced their
/// residual to 0.15 and hide no more than their step in it (NewtonCorrection::Result::hidden), the gap between the two
/// fields of the iteration is below ten times the accuracy, and no body was thrown far away. If E is too large the
/// state moves on to a1 + d2 and the next correction is compared with this one. In E, kappa counts as 0.8 at most.
///
/// The gap is max(|f - f^| / |f^|, |w - w^| / |w|): with f - f^ = -k (w - w^) one of them is large for any k far from
/// the stiffness of the bodies, so an absurd k cannot hide behind small changes.
class Certificate {
 public:
  /// What came of an attempt.
  struct Result {
    bool claimed = false;           ///< E is within the accuracy, and all else that a claim needs is given
    bool conclusive = false;        ///< both corrections could be computed; `estimates` holds E
    std::vector<double> estimates;  ///< as Snapshot::distance: responses, force field, displacement field
    base::Matrix state;             ///< the state that the estimates belong to, or the best one to go on from
    double contraction = 1.0;       ///< kappa [-]
  };

  /// All arguments must outlive it. `accuracy`: relative [-].
  Certificate(FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses, double accuracy)
      : fixedPoint_(fixedPoint), responses_(responses), accuracy_(accuracy), newton_(fixedPoint) {}

  /// Collective. `image` = T(alpha), and `iterate` is that of alpha, at the beginning. Leaves at most at `stageLimit`
  /// linear stages in all, counted as LinearStage::stages(). Throws base::Error as Snapshot.
  Result attempt(const Iterate& iterate, const base::Matrix& alpha, const base::Matrix& image, int stageLimit);

 private:
  FixedPoint& fixedPoint_;
  const std::vector<std::shared_ptr<const Response>>& responses_;
  double accuracy_;
  NewtonCorrection newton_;
};

/// The gap that a claim allows, over the accuracy.
inline constexpr double allowedGap = 10.0;

/// The gap between the fields of both stages, see Certificate. Collective.
double fieldGap(const Iterate& state);

}  // namespace harmos::latin
