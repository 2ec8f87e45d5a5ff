#pragma once

#include <string>
#include <vector>

#include <harmos/results/StochasticSummary.hpp>

namespace harmos::files {

/// Where the results of a study with random parameters lie; `base`: DIR/STUDY.
struct StochasticFiles {
  /// Appends the endings below to `base`.
  explicit StochasticFiles(const std::string& base);

  std::string moments;       // STUDY_moments.csv
  std::string sobol;         // STUDY_sobol.csv
  std::string coefficients;  // STUDY_coefficients.csv
  std::string sweep;         // STUDY_sweep.csv, of studies that sweep
  std::string parts;         // STUDY.e and
  std::string interfaces;    // STUDY_interfaces.e, where fields were expanded

  /// These six paths, whether there are such files or not.
  std::vector<std::string> all() const { return {moments, sobol, coefficients, sweep, parts, interfaces}; }
  /// Those that there are.
  std::vector<std::string> written() const;
};

/// Writes the tables; what is undefined is "n/a", what is not known is left empty. Each replaces an older file in one
/// step; throws base::Error when it cannot.
///   moments: response, mean, std, skewness, kurtosis, mean_error, std_error, iteration_error, truncation,
///     hold_out_error
///   sobol: response, variables (joined by "*"), main, total
///   coefficients: response, a column of degrees per variable, coefficient; orthonormal polynomials in graded
///     lexicographic order
///   sweep: coefficients of variation, then mean and std of every response
/// Of correlated variables the indices and degrees are those of the independent germs xi_1, xi_2, .. behind them.
void writeStochasticTables(const StochasticFiles& files, const results::StochasticSummary& summary);

}  // namespace harmos::files
