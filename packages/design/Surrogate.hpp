#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

namespace harmos::design {

/// A response surface with error bars through the results of a study: a polynomial, and a Gaussian process for what the
/// polynomial leaves (universal kriging).
///
/// y(x) = f(x).b + z(x), with f all monomials up to the degree and z of zero mean and covariance
/// s^2 (R(x, x') + nugget [x = x']). R is the Matern function 5/2 of the distance in units of one correlation length
/// per parameter; x runs from -1 to 1 over the box of the points. Lengths and nugget maximise the restricted
/// likelihood, b and s follow. The deviation of kriging is multiplied by a calibration, at least 1, so that 95 % of
/// the leave-one-out errors lie within 1.96 of their deviations. Source: Santner, Williams, Notz, The Design and
/// Analysis of Computer Experiments (2018), ch. 4; leave-one-out: Dubrule, Math. Geol. 15 (1983),
/// doi:10.1007/BF01033232.
class Surrogate {
 public:
  /// What was chosen for a surrogate; the rest follows from the points.
  struct Model {
    int degree = 0;                    // of the polynomial: 0, 1 or 2
    std::vector<double> lower, upper;  // box of the points, in the units of the parameters
    std::vector<double> lengths;       // of correlation, per parameter, in half widths of the box
    double nugget = 0.0;               // variance of what differs between two solutions of one point, in units of s^2
    double calibration = 1.0;          // factor of the deviations, at least 1
  };
  /// The surface at one point.
  struct Prediction {
    double value = 0.0;      // in the unit of the response
    double deviation = 0.0;  // one standard deviation, calibrated; same unit as the value
    bool isInside = true;    // of the box of the points: otherwise it is an extrapolation
  };

  /// `points` [point][parameter], in the units of the parameters, all different, every parameter with at least two
  /// values. `uncertainty`: how far the values may be from those of an exact solution, in their unit; the surrogate
  /// smooths over no more than that. Throws base::Error when there are fewer than 3 points, a value is not finite or
  /// the correlations of the points are singular.
  Surrogate(std::vector<std::vector<double>> points, std::vector<double> values, double uncertainty);

  /// `point`: one value per parameter, in its unit.
  Prediction evaluate(const std::vector<double>& point) const;
  /// Lives as long as the surrogate.
  const Model& model() const { return model_; }
  /// Largest difference between the value at a point and what the others predict there, in the unit of the response.
  double largestLeftOutError() const { return largestLeftOutError_; }
  /// Root mean square of these differences, in the same unit.
  double meanLeftOutError() const { return meanLeftOutError_; }
  /// The deviations at `candidates` if the surrogate had also known the values at `more`; these values do not matter.
  /// All are 0 when `more` makes the correlations singular, as a point that is known already does.
  std::vector<double> deviationsWith(const std::vector<std::vector<double>>& more,
                                     const std::vector<std::vector<double>>& candidates) const;

 private:
  /// The factored equations of kriging for one choice of lengths and nugget.
  struct System {
    base::Matrix factor;               // L of the correlations of the points
    base::Matrix trend;                // L^-1 F
    base::Matrix trendFactor;          // Cholesky factor of F^T C^-1 F
    std::vector<double> coefficients;  // b
    std::vector<double> weights;       // C^-1 (y - F b)
    double variance = 0.0;             // s^2
    double score = 0.0;                // the less the more likely
  };

  std::vector<double> scaled(const std::vector<double>& point) const;
  std::vector<double> monomials(const std::vector<double>& x) const;
  double correlation(const std::vector<double>& x, const std::vector<double>& y) const;
  /// False when the correlations are singular to working precision.
  bool solve(const std::vector<std::vector<double>>& points, const std::vector<double>& values, System& system) const;
  double deviation(const System& system, const std::vector<std::vector<double>>& points,
                   const std::vector<double>& x) const;
  void chooseModel(double uncertainty);
  void calibrate();

  Model model_;
  std::vector<std::vector<double>> points_;  // scaled
  std::vector<double> values_;
  System system_;
  double largestLeftOutError_ = 0.0, meanLeftOutError_ = 0.0;
};

}  // namespace harmos::design
