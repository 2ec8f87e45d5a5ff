#pragma once

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// X is anywhere between two bounds with equal probability; the germ is uniform on [-1, 1].
class Uniform : public Distribution {
 public:
  /// Bounds in the unit of X, lower < upper. Throws base::Error (input) for others.
  Uniform(double lower, double upper);

  const char* name() const override { return "Uniform"; }
  /// (lower + upper) / 2.
  double mean() const override { return 0.5 * (lower_ + upper_); }
  /// (upper - lower) / sqrt(12).
  double standardDeviation() const override;
  double value(double germ) const override { return mean() + 0.5 * (upper_ - lower_) * germ; }
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return polynomials_; }
  bool isAffine() const override { return true; }

 private:
  double lower_, upper_;
  Polynomials polynomials_ = Polynomials::legendre();
};

}  // namespace harmos::probability
