#pragma once

#include <vector>

namespace harmos::probability {

/// Points of a density.
struct DensityCurve {
  std::vector<double> points;  // in the unit of the sample, ascending
  std::vector<double> values;  // one per point, per unit of the sample
};

/// What a sample of independent numbers tells of the law that they were drawn from.
///
/// What is divided by the variance is NaN when all values are equal, and so is what needs more values than there are.
class SampleStatistics {
 public:
  /// Throws base::Error when there is no value or one is not finite.
  explicit SampleStatistics(std::vector<double> values);

  /// Number of values.
  int count() const { return static_cast<int>(values_.size()); }
  /// Ascending.
  const std::vector<double>& values() const { return values_; }
  /// In the unit of the sample.
  double mean() const { return mean_; }
  /// In the unit of the sample, with n - 1.
  double standardDeviation() const { return deviation_; }
  /// Third central moment divided by the second one to the power 3/2 (both with n) [-]; 0 of a normal law.
  double skewness() const { return skewness_; }
  /// Fourth central moment divided by the square of the second one (both with n) [-]; 3 of a normal law.
  double kurtosis() const { return kurtosis_; }
  /// Standard error of the mean, s / sqrt(n).
  double meanError() const;
  /// Standard error of the standard deviation, s / 2 sqrt((kurtosis - (n - 3) / (n - 1)) / n), for large n.
  double standardDeviationError() const;
  /// Linear between the order statistics, 0 <= p <= 1: 0 gives the least value and 1 the largest. Throws base::Error
  /// for other p.
  double quantile(double p) const;
  /// Share of the values that are not above x.
  double cumulative(double x) const;
  /// Sum of Gaussian kernels at evenly spaced points, four kernel widths beyond the values on both sides. The width is
  /// 0.9 min(s, interquartile range / 1.34) / n^(1/5), with s alone where this range is 0. Empty when all values are
  /// equal or there is only one. Throws base::Error for fewer than 2 points. Source: Silverman, Density Estimation
  /// (1986), eq. 3.31.
  DensityCurve density(int points) const;

 private:
  std::vector<double> values_;
  double mean_, deviation_, skewness_, kurtosis_;
};

/// Largest difference between the cumulative shares of two samples, 0 to 1 (Kolmogorov and Smirnov).
double largestDifference(const SampleStatistics& a, const SampleStatistics& b);

}  // namespace harmos::probability
