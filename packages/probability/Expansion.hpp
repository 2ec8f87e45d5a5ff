#pragma once

#include <memory>
#include <vector>

#include <harmos/probability/Quadrature.hpp>

namespace harmos::probability {

/// A random number expanded on a basis: Y = sum over a of y_a psi_a(xi).
///
/// y_0 is the mean, the sum of the other y_a^2 the variance. Germs have no unit.
class Expansion {
 public:
  /// One coefficient y_a per polynomial, in the unit of Y; `basis` is shared. Throws base::Error when their number is
  /// another.
  Expansion(std::shared_ptr<const Basis> basis, std::vector<double> coefficients);

  /// The polynomials; it lives as long as the expansion.
  const Basis& basis() const { return *basis_; }
  /// One y_a per polynomial, in the unit of Y.
  const std::vector<double>& coefficients() const { return coefficients_; }
  /// Y at one point, `germs` [germ].
  double evaluate(const std::vector<double>& germs) const;

  /// In the unit of Y.
  double mean() const { return coefficients_[0]; }
  /// In the unit of Y.
  double standardDeviation() const;
  /// Standardised third moment E[(Y - E[Y])^3] / deviation^3 [-], exact for the expansion; NaN at zero variance. Throws
  /// base::Error when a germ has too few polynomials: up to twice the order is always enough.
  double skewness() const;
  /// The same of the fourth power; 3 of a normal law.
  double kurtosis() const;
  /// Share of the variance that is in the polynomials of the highest degree: what tells of truncation. NaN at zero
  /// variance.
  double lastDegreeShare() const;

 private:
  std::shared_ptr<const Basis> basis_;
  std::vector<double> coefficients_;
};

/// The expansion of a random number by its values at the points of a quadrature: y_a = sum of w_q psi_a(xi_q) values_q.
///
/// `values`: one per point, in the unit of Y. `basis` is shared by the expansion.
Expansion project(std::shared_ptr<const Basis> basis, const Quadrature& quadrature, const std::vector<double>& values);

/// Sobol' indices of an expansion: shares of its variance [-]. Source: Sudret, Reliab. Eng. Syst. Saf. 93 (2008),
/// doi:10.1016/j.ress.2007.04.002.
struct SobolIndex {
  std::vector<int> germs;  // of which the share is, from 0, ascending
  double main = 0.0;       // of these germs together and of no smaller set; NaN at zero variance
  double total = 0.0;      // of all sets that contain these germs
};

/// One for every set of germs that a polynomial of the basis has, the single ones first, sets of equal size in
/// lexicographic order.
std::vector<SobolIndex> sobolIndices(const Expansion& expansion);

}  // namespace harmos::probability
