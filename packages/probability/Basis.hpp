#pragma once

#include <memory>
#include <vector>

#include <harmos/probability/RandomVector.hpp>

namespace harmos::probability {

/// Orthonormal polynomials in several independent germs up to a total degree: psi_a(xi) = product of p_{a_i}(xi_i) with
/// |a| = sum of a_i <= order, in graded lexicographic order: (00), (10), (01), (20), (11), (02) and so on.
///
/// Their number is C(dimension + order, order); psi_0 = 1 and E[psi_a psi_b] = delta_ab.
class Basis {
 public:
  /// `variables` is shared. Throws base::Error (input) when the order is negative, a germ has no polynomials of this
  /// degree, or there would be more than 1e5 of them.
  Basis(std::shared_ptr<const RandomVector> variables, int order);

  /// Number of polynomials.
  int size() const { return static_cast<int>(indices_.size()); }
  /// Largest total degree.
  int order() const { return order_; }
  /// The germs, and the random parameters behind them; lives as long as the basis.
  const RandomVector& variables() const { return *variables_; }
  /// The same, to be shared.
  std::shared_ptr<const RandomVector> variablesPointer() const { return variables_; }
  /// Degree in every germ, one row per polynomial.
  const std::vector<std::vector<int>>& indices() const { return indices_; }
  /// psi_0(xi) .. psi_{size-1}(xi) at one point, `germs` [germ].
  std::vector<double> evaluate(const std::vector<double>& germs) const;

 private:
  std::shared_ptr<const RandomVector> variables_;
  int order_;
  std::vector<std::vector<int>> indices_;
};

}  // namespace harmos::probability
