#pragma once

#include <memory>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/probability/Expansion.hpp>

namespace harmos::probability {

/// Fits expansions to values at given points of germs: the coefficients with the least sum of squared residuals.
///
/// One factorisation serves any number of responses. Points drawn from the law of the germs, at least two or three for
/// each polynomial, give a well-conditioned fit.
class Regression {
 public:
  /// An expansion through values, and how far to trust it.
  struct Fit {
    Expansion expansion;  // shares the basis
    /// Root mean square of the differences between each value and the fit to all others, relative to the standard
    /// deviation of the values; NaN when all values are equal or the points are no more than the polynomials. Source:
    /// Blatman, Sudret, J. Comput. Phys. 230 (2011), doi:10.1016/j.jcp.2010.12.021, sec. 4.
    double leaveOneOutError;
  };

  /// `basis` is shared; `points` [sample][germ]. Throws base::Error (input) when the points are too few or too alike to
  /// tell the polynomials apart.
  Regression(std::shared_ptr<const Basis> basis, const std::vector<std::vector<double>>& points);

  /// One value per point, in the unit of the response. Throws base::Error when a value is missing or not finite.
  Fit fit(const std::vector<double>& values) const;

 private:
  std::shared_ptr<const Basis> basis_;
  base::Matrix q_, r_;  // psi_a(xi_s) = Q R, samples x polynomials
};

}  // namespace harmos::probability
