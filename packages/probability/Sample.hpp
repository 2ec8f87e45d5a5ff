#pragma once

#include <optional>
#include <vector>

#include <harmos/probability/Distribution.hpp>

namespace harmos::probability {

/// One of a list of observed values, each as probable as the others; the germ is X standardised to mean 0 and standard
/// deviation 1 (that of the list itself, divided by n).
///
/// The cumulative probability rises in steps at the values, and quantiles are values of the list. There are as many
/// polynomials as different values, at most 65.
class Sample : public Distribution {
 public:
  /// In the unit of X, in any order, finite; at least two must differ. Throws base::Error (input) for others.
  explicit Sample(std::vector<double> values);

  const char* name() const override { return "Sample"; }
  /// Of the list.
  double mean() const override { return mean_; }
  /// Of the list, divided by n.
  double standardDeviation() const override { return deviation_; }
  double value(double germ) const override { return mean_ + deviation_ * germ; }
  double germ(double u) const override;
  double germExceeded(double v) const override;
  double cumulative(double x) const override;
  const Polynomials& polynomials() const override { return *polynomials_; }
  bool isAffine() const override { return true; }

 private:
  std::vector<double> values_;  // ascending
  double mean_, deviation_;
  std::optional<Polynomials> polynomials_;
};

}  // namespace harmos::probability
