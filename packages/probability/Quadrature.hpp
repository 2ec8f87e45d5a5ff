#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/probability/Basis.hpp>

namespace harmos::probability {

/// Points of germs and their weights: E[f] is about sum of w_q f(xi_q). The weights add up to 1; those of a sparse grid
/// may be negative.
struct Quadrature {
  std::vector<std::vector<double>> points;  // [point][germ]
  std::vector<double> weights;              // one per point [-]

  /// Number of points.
  int size() const { return static_cast<int>(weights.size()); }
};

/// Points of the largest tensor grid at which a function is evaluated that costs no solve.
constexpr double mostPointsWithoutSolves = 2e4;

/// All combinations of the Gauss points of each germ, the last germ fastest. Throws base::Error as
/// Polynomials::gauss().
Quadrature tensorQuadrature(const RandomVector& variables, int pointsPerGerm);
/// The same with a number of points for each germ, `points` [germ].
Quadrature tensorQuadrature(const RandomVector& variables, const std::vector<int>& points);

/// Smolyak's sparse grid of Gauss rules, exact for products of two polynomials of the basis. Source: Smolyak, Dokl.
/// Akad. Nauk SSSR 148 (1963).
Quadrature sparseQuadrature(const Basis& basis);

/// psi_a(xi_q), points x polynomials.
base::Matrix valuesAt(const Basis& basis, const Quadrature& quadrature);

/// From values at the points to coefficients: w_q psi_a(xi_q), polynomials x points.
base::Matrix projector(const Basis& basis, const Quadrature& quadrature);

}  // namespace harmos::probability
