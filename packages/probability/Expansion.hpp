#pragma once

#include <memory>
#include <vector>

#include <harmos/probability/Quadrature.hpp>

namespace harmos::probability {

/// A random number expanded on a basis: Y = sum over a of y_a psi_a(xi).
class Expansion {
 public:
  /// One coefficient per polynomial, in the unit of Y.
  Expansion(std::shared_ptr<const Basis> basis, std::vector<double> coefficients);

  const Basis& basis() const { return *basis_; }
  const std::vector<double>& coefficients() const { return coefficients_; }
  double evaluate(const std::vector<double>& germs) const;

  double mean() const { return coefficients_[0]; }
  double standardDeviation() const;
  /// Standardised third and fourth moments, exact for the expansion; NaN at zero variance.
  double skewness() const;
  double kurtosis() const;
  /// Share of the variance that is in the polynomials of the highest degree: what tells of truncation. NaN at zero
  /// variance.
  double lastDegreeShare() const;

 private:
  std::shared_ptr<const Basis> basis_;
  std::vector<double> coefficients_;
};

/// The expansion of a random number by its values at the points of a quadrature: y_a = sum of w_q psi_a(xi_q) values_q.
Expansion project(std::shared_ptr<const Basis> basis, const Quadrature& quadrature, const std::vector<double>& values);

/// Sobol' indices of an expansion: shares of its variance. Source: Sudret, Reliab. Eng. Syst. Saf. 93 (2008).
struct SobolIndex {
  std::vector<int> germs;  // of which the share is, ascending
  double main = 0.0;       // of these germs together and of no smaller set; NaN at zero variance
  double total = 0.0;      // of all sets that contain these germs
};

/// One for every set of germs that a polynomial of the basis has, the single ones first.
std::vector<SobolIndex> sobolIndices(const Expansion& expansion);

}  // namespace harmos::probability
