#pragma once

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// X = exp(m + s xi) with a standard normal germ; always positive.
///
/// s^2 = ln(1 + (standard deviation / mean)^2), m = ln(mean) - s^2 / 2, mean and standard deviation being those of X.
class Lognormal : public Distribution {
 public:
  /// Of X itself and in its unit: the mean is positive, the standard deviation at least 0: X may be constant. Throws
  /// base::Error (input) for others.
  Lognormal(double mean, double standardDeviation);

  const char* name() const override { return "Lognormal"; }
  /// As given.
  double mean() const override { return mean_; }
  /// As given.
  double standardDeviation() const override { return deviation_; }
  double value(double germ) const override;
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return polynomials_; }
  bool isAffine() const override { return false; }

 private:
  double mean_, deviation_;
  double logMean_, logDeviation_;
  Polynomials polynomials_ = Polynomials::hermite();
};

}  // namespace harmos::probability
