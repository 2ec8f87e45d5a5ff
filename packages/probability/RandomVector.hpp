#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/probability/Distribution.hpp>

/// Random parameters: distributions, polynomials of germs, quadratures, expansions and statistics.
namespace harmos::probability {

/// One random parameter.
struct Variable {
  std::string name;                                  // as in the study
  std::shared_ptr<const Distribution> distribution;  // its law, in its unit; not null
};

/// All random parameters of a study, as functions of independent germs.
///
/// Independent parameters have the germs of their own distributions. Correlated ones are joined by a Gaussian copula:
/// z = L xi with L L^T the matrix of correlations and xi independent standard normal germs, X_i = F_i^-1(Phi(z_i)).
/// Source: Liu, Der Kiureghian, Probab. Eng. Mech. 1 (1986), doi:10.1016/0266-8920(86)90033-0, with the correlations
/// given for z.
class RandomVector {
 public:
  /// `correlation`: of the Gaussian variables z, dimension x dimension, 1 on the diagonal; empty (0 x 0): independent.
  /// Throws base::Error (input) when it is not symmetric and positive definite, has another size, or there is no
  /// variable.
  explicit RandomVector(std::vector<Variable> variables, const base::Matrix& correlation = {});

  /// Number of random parameters, and of germs.
  int dimension() const { return static_cast<int>(variables_.size()); }
  /// In the order given.
  const std::vector<Variable>& variables() const { return variables_; }
  /// Whether no matrix of correlations was given.
  bool isIndependent() const { return factor_.numRows() == 0; }
  /// Of germ i, from 0; lives as long as the vector. Of correlated parameters they are Hermite.
  const Polynomials& polynomials(int i) const;
  /// Values of all parameters, in their units, at a point of germs.
  std::vector<double> values(const std::vector<double>& germs) const;
  /// The germs of a point of independent numbers that are uniform on (0, 1). Throws base::Error for one out
  /// of it.
  std::vector<double> germs(const std::vector<double>& uniform) const;

 private:
  std::vector<Variable> variables_;
  base::Matrix factor_;  // L
};

}  // namespace harmos::probability
