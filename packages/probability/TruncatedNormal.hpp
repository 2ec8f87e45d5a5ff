#pragma once

#include <optional>

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// A normal number, the parent, of which only the values between two bounds occur; the germ is X standardised to mean 0
/// and standard deviation 1.
///
/// Polynomials, mean and standard deviation come from the density at the points of Gauss rules on panels (Gautschi,
/// Orthogonal Polynomials (2004), sec. 2.2: discretised Stieltjes). They are known up to degree 64.
class TruncatedNormal : public Distribution {
 public:
  /// Mean and standard deviation (above 0) of the parent, and at least one bound, all in the unit of X; lower < upper.
  /// Throws base::Error (input) for others, and when the parent lies between the bounds with less than 1e-250.
  TruncatedNormal(double parentMean, double parentDeviation, std::optional<double> lower, std::optional<double> upper);

  const char* name() const override { return "Truncated Normal"; }
  /// Of X, not of the parent.
  double mean() const override { return mean_; }
  /// Of X, not of the parent.
  double standardDeviation() const override { return deviation_; }
  double value(double germ) const override { return mean_ + deviation_ * germ; }
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return *polynomials_; }
  bool isAffine() const override { return true; }

 private:
  double germAt(double u, double v) const;

  double parentMean_, parentDeviation_;
  double lower_, upper_;  // bounds of the standardised parent
  double probability_;    // that the parent lies between them
  double mean_, deviation_;
  std::optional<Polynomials> polynomials_;
};

}  // namespace harmos::probability
