#pragma once

#include <memory>

#include <harmos/base/Matrix.hpp>
#include <harmos/probability/Basis.hpp>
#include <harmos/probability/Quadrature.hpp>

namespace harmos::stochastic {

/// The way between the coefficients of random numbers on a basis and their values at the points of a quadrature.
class Projection {
 public:
  /// The basis is shared. The points of the quadrature have the germs of the basis.
  Projection(std::shared_ptr<const probability::Basis> basis, probability::Quadrature quadrature);

  /// The polynomials psi_a, orthonormal.
  const std::shared_ptr<const probability::Basis>& basis() const { return basis_; }
  /// Points xi_q and weights w_q.
  const probability::Quadrature& quadrature() const { return quadrature_; }
  /// Polynomials of the basis.
  int terms() const { return basis_->size(); }
  /// Points of the quadrature.
  int points() const { return quadrature_.size(); }
  /// psi_a(xi_q), points x terms.
  const base::Matrix& values() const { return values_; }
  /// w_q psi_a(xi_q), terms x points.
  const base::Matrix& projector() const { return projector_; }

  /// Values at the points, rows x points, of numbers with these coefficients, rows x terms. Reshapes the result.
  void toPoints(const base::Matrix& coefficients, base::Matrix& values) const;
  /// The other way; exact as far as the quadrature is.
  void toCoefficients(const base::Matrix& values, base::Matrix& coefficients) const;

 private:
  std::shared_ptr<const probability::Basis> basis_;
  probability::Quadrature quadrature_;
  base::Matrix values_;
  base::Matrix projector_;
};

}  // namespace harmos::stochastic
