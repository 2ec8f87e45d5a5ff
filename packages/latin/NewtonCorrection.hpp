#pragma once

#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// One inexact Newton step for alpha = T(alpha): (I - J) d = T(alpha) - alpha by GMRES in the state metric.
///
/// J v is the directional difference (T(alpha + e v) - T(alpha)) / e, so any law will do; one vector costs one
/// iteration. Source: Knoll, Keyes (2004), doi:10.1016/j.jcp.2003.08.010.
class NewtonCorrection {
 public:
  struct Result {
    base::Matrix step;                 ///< d [stress]
    double reduction = 1.0;            ///< |(I - J) d - r| / |r|
    double smallestSingularValue = 0;  ///< of the Hessenberg matrix of I - J; near 0 when there is no equilibrium
    int vectors = 0;
  };

  NewtonCorrection(FixedPoint& fixedPoint, int maximumVectors) : fixedPoint_(fixedPoint), maximum_(maximumVectors) {}

  /// Collective. `image` = T(alpha). Stops at the relative residual `target` or at the largest number of vectors.
  Result solve(const base::Matrix& alpha, const base::Matrix& image, double target);

 private:
  FixedPoint& fixedPoint_;
  int maximum_;
};

}  // namespace harmos::latin
