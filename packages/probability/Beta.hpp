#pragma once

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// X between two bounds with the density (x - lower)^(alpha - 1) (upper - x)^(beta - 1), but for a factor; the germ is
/// X scaled to [-1, 1].
class Beta : public Distribution {
 public:
  /// Bounds in the unit of X, lower < upper; the shapes `alpha` and `beta` are positive [-]. Throws base::Error (input)
  /// for others.
  Beta(double lower, double upper, double alpha, double beta);

  const char* name() const override { return "Beta"; }
  /// lower + (upper - lower) alpha / (alpha + beta).
  double mean() const override;
  /// (upper - lower) / (alpha + beta) sqrt(alpha beta / (alpha + beta + 1)).
  double standardDeviation() const override;
  double value(double germ) const override;
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return polynomials_; }
  bool isAffine() const override { return true; }

 private:
  double lower_, upper_, alpha_, beta_;
  Polynomials polynomials_;
};

}  // namespace harmos::probability
