#pragma once

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// X = mean + standard deviation * xi with a standard normal germ. It takes negative values, however rarely: 1/X has no
/// variance.
class Normal : public Distribution {
 public:
  /// In the unit of X. The standard deviation is at least 0: X may be constant. Throws base::Error (input) for others.
  Normal(double mean, double standardDeviation);

  const char* name() const override { return "Normal"; }
  /// As given.
  double mean() const override { return mean_; }
  /// As given.
  double standardDeviation() const override { return deviation_; }
  double value(double germ) const override { return mean_ + deviation_ * germ; }
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return polynomials_; }
  bool isAffine() const override { return true; }

 private:
  double mean_, deviation_;
  Polynomials polynomials_ = Polynomials::hermite();
};

}  // namespace harmos::probability
