#pragma once

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// X between two bounds with the density (x - lower)^(alpha - 1) (upper - x)^(beta - 1), but for a factor; the germ is
/// X scaled to [-1, 1].
class Beta : public Distribution {
 public:
  /// lower < upper; alpha and beta are positive.
  Beta(double lower, double upper, double alpha, double beta);

  const char* name() const override { return "Beta"; }
  double mean() const override;
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
