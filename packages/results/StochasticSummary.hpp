#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <harmos/probability/Expansion.hpp>

namespace harmos::results {

/// What is known of one random response. Not a number: not known, or undefined at zero variance.
struct ResponseStatistics {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  std::string name;
  double mean = unknown, standardDeviation = unknown;
  double skewness = unknown, kurtosis = unknown;  // kurtosis of a normal response: 3
  // Of a sample: standard errors. Of an expansion or interpolation that was solved for: error estimates.
  double meanError = unknown, deviationError = unknown;
  double truncation = unknown;    // share of the variance in the polynomials of the highest degree
  double holdOutError = unknown;  // root mean square error at the configurations held out, over standard deviation
  std::shared_ptr<const probability::Expansion> expansion;  // null when there is none
  std::vector<probability::SobolIndex> sobol;               // empty when there are none
  std::vector<double> quantiles;                            // at StochasticSummary::levels
  std::vector<double> values, density, cumulative;          // the density is an estimate; three arrays of equal length
};

/// What a study with random parameters ends with.
struct StochasticSummary {
  /// Moments of an expansion of one order.
  struct Order {
    int order = 0;
    std::vector<double> means, deviations;
  };
  /// Of one combination of coefficients of variation.
  struct Point {
    std::vector<double> coefficients;
    std::vector<double> means, deviations;
  };

  std::string method;     // in words
  bool isSample = false;  // whether the figures are those of the configurations, not of an expansion or interpolation
  std::vector<std::string> variables;
  std::vector<std::string> distributions;  // in words, one per variable
  bool hasIndependentVariables = true;
  std::vector<double> levels;  // of quantiles
  std::vector<ResponseStatistics> responses;
  std::vector<Order> convergence;
  std::vector<std::string> sweepNames;
  std::vector<Point> sweep;
  int solved = 0;        // configurations behind the figures
  int inadmissible = 0;  // draws with values that the scene refuses, which are left out

  /// What Sobol' indices and degrees belong to: the variables, or where these are correlated, independent germs.
  std::string germName(int germ) const {
    return hasIndependentVariables ? variables[germ] : "xi_" + std::to_string(germ + 1);
  }
};

}  // namespace harmos::results
