#pragma once

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// One inexact Newton step for alpha = T(alpha): (I - J) d = T(alpha) - alpha by GMRES in the state metric.
///
/// J v is the directional difference (T(alpha + e v) - T(alpha)) / e, so any law will do; one vector costs one
/// iteration. Source: Knoll, Keyes (2004), doi:10.1016/j.jcp.2003.08.010.
class NewtonCorrection {
 public:
  /// The step and what is known of it.
  struct Result {
    base::Matrix step;                 ///< d [stress]
    double reduction = 1.0;            ///< |(I - J) d - r| / |r|
    double smallestSingularValue = 0;  ///< of the Hessenberg matrix of I - J; near 0 when there is no equilibrium
    /// What the remaining residual can hide: |(I - J) d - r| over the smallest singular value met so far, over |d|.
    /// Slow modes are all but absent from the residual.
    double hidden = 0.0;
    int vectors = 0;  ///< of Krylov: applications of T
  };

  /// `fixedPoint` must outlive it.
  explicit NewtonCorrection(FixedPoint& fixedPoint) : fixedPoint_(fixedPoint) {}

  /// Collective. `image` = T(alpha), `iterate` that of alpha, at the beginning. Stops at the relative residual `target`
  /// when no more than half of the step can be hidden, or at the largest number of vectors. Applies T to other
  /// states, so that `iterate` is not to be read afterwards.
  Result solve(const Iterate& iterate, const base::Matrix& alpha, const base::Matrix& image, double target,
               int maximumVectors);

 private:
  FixedPoint& fixedPoint_;
  double slowest_ = 1.0;  // smallest singular value met so far
};

}  // namespace harmos::latin
