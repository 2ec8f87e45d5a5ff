#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <harmos/probability/Expansion.hpp>
#include <harmos/results/Interpolant.hpp>

namespace harmos::results {

/// What is known of one random response. Not a number: not known, or undefined at zero variance.
struct ResponseStatistics {
  /// What a number is when nothing is known of it.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  /// Of the scalar response.
  std::string name;
  /// In the unit of the response.
  double mean = unknown, standardDeviation = unknown;  // the same
  /// Standardised third and fourth moments [-].
  double skewness = unknown, kurtosis = unknown;  // kurtosis of a normal response: 3
  /// Of a sample: standard errors. Of an expansion or interpolation: estimates of the whole error, of what the
  /// iteration left, of truncation and of the quadrature. In the unit of the response.
  double meanError = unknown, deviationError = unknown;  // the same of the standard deviation
  double iterationError = unknown;                       // its share that the iteration left; of a sample unknown
  double truncation = unknown;  // share of the variance in the polynomials of the highest degree
  /// Root mean square error at the configurations held out, over standard deviation. Of an expansion that was fitted to
  /// a sample: its leave-one-out error.
  double holdOutError = unknown;
  /// Standard deviation of the response from its expansion at a random point, in the unit of the response: of error
  /// bars.
  double predictionError = unknown;
  std::shared_ptr<const probability::Expansion> expansion;  // null when there is none
  std::vector<probability::SobolIndex> sobol;               // empty when there are none
  std::vector<double> quantiles;                            // at StochasticSummary::levels, in the unit of the response
  /// Three arrays of equal length.
  std::vector<double> values,  // in the unit of the response, ascending
      density,                 // per this unit; an estimate
      cumulative;              // probability not to exceed the value
};

/// What a study with random parameters ends with.
struct StochasticSummary {
  /// Moments of an expansion of one order.
  struct Order {
    int order = 0;
    std::vector<double> means, deviations;  // per response, in its unit
  };
  /// Of one combination of coefficients of variation.
  struct Point {
    std::vector<double> coefficients;       // of variation [-], one per name in sweepNames
    std::vector<double> means, deviations;  // per response, in its unit
  };

  std::string method;     // in words
  bool isSample = false;  // whether the figures are those of the configurations, not of an expansion or interpolation
  std::vector<std::string> variables;                           // names of the random parameters
  std::vector<std::string> distributions;                       // in words, one per variable
  bool hasIndependentVariables = true;                          // false: a Gaussian copula joins them
  std::vector<double> levels;                                   // of quantiles: probabilities, 0 to 1
  std::vector<ResponseStatistics> responses;                    // in the order of the study
  std::shared_ptr<const Interpolant> interpolant;               // null when there is none
  std::shared_ptr<const probability::RandomVector> randomness;  // of the interpolant
  std::vector<Order> convergence;                               // by ascending order; may be empty
  std::vector<std::string> sweepNames;  // of the parameters whose coefficients of variation are swept
  std::vector<Point> sweep;             // empty without a sweep
  int solved = 0;                       // configurations behind the figures
  int inadmissible = 0;                 // draws with values that the scene refuses, which are left out
  int unsolved = 0;                     // draws without a solution, which are left out as well
  std::vector<std::string> warnings;    // what makes the figures doubtful, in words

  /// What Sobol' indices and degrees belong to: the variables, or where these are correlated, independent germs. `germ`
  /// counts from 0.
  std::string germName(int germ) const {
    return hasIndependentVariables ? variables[germ] : "xi_" + std::to_string(germ + 1);
  }
};

}  // namespace harmos::results
