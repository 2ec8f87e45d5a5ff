#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::laws {

/// How a random field of variance 1 is correlated with itself over a distance d, l the correlation length.
enum class Covariance {
  exponential,  ///< exp(-d / l): rough
  gaussian      ///< exp(-(d / l)^2): smooth
};

/// Expansion of a Gaussian random field of mean 0 and variance 1 over a surface: g(x) = sum_k sqrt(lambda_k) phi_k(x)
/// xi_k with independent standard normal xi_k. lambda_k, phi_k: int C(x, y) phi_k(y) dy = lambda_k phi_k(x), with
/// the points of the surface and their areas for the integral (Nystroem's method).
///
/// The largest lambda come first. Source: Ghanem, Spanos, Stochastic Finite Elements (1991), section 2.3; low rank by
/// pivoted Cholesky: Harbrecht, Peters, Schneider, Appl. Numer. Math. 62 (2012), doi:10.1016/j.apnum.2011.10.001.
class KarhunenLoeve {
 public:
  /// `places` [length], each once, with their areas [area], above 0; `length`: l [length], above 0; `wanted`: of how
  /// many terms the functions are needed. Takes n r^2
  /// operations, r the rank that holds all but 1e-6 of the variance, at most 1000.
  KarhunenLoeve(std::vector<base::Vector3> places, const std::vector<double>& areas, Covariance covariance,
                double length, int wanted);

  /// How many terms there are, but for round-off.
  int terms() const { return static_cast<int>(eigenvalues_.size()); }
  /// Share of the variance, integrated over the surface, that the first `count` terms hold, from 0 to 1.
  double share(int count) const;
  /// sqrt(lambda_k) phi_k of the terms that were wanted, as far as there are, at point number `point`.
  std::vector<double> atPoint(int point) const;
  /// The same at any place, by the integral equation: takes as many operations as there are points.
  std::vector<double> at(const base::Vector3& place) const;

 private:
  double correlation(const base::Vector3& a, const base::Vector3& b) const;

  std::vector<base::Vector3> places_;
  Covariance covariance_;
  double length_, area_ = 0.0;
  std::vector<double> eigenvalues_;  // descending [area]
  base::Matrix modes_;               // points x wanted terms: sqrt(lambda_k) phi_k
  std::vector<double> areas_;
};

}  // namespace harmos::laws
