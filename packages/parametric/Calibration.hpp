#pragma once

#include <vector>

#include <harmos/results/Evidence.hpp>

namespace harmos::parametric {

/// Reads free indicators as errors, with ratios measured in the same study.
///
/// Configurations that were iterated on to a tight stop know the errors of the states on their way:
///   kf = min force indicator / error of the force field,  kc = min indicator of a response / its error,
/// over their states with errors between 0.1 and 10 times the accuracy asked for, where smaller errors of responses
/// count as 0.1 times where another is larger, and indicators of 0 do not count; all at most 1. The others have
///   E = max(force indicator / kf, largest indicator / kc of a response, balance).
/// A calibrated estimate, not a bound: ratios differ between scenes and search directions, never carry them over.
class Calibration {
 public:
  /// One state on the way of a calibration run, with its errors against the end of the run.
  struct Observation {
    results::Indicators indicators;
    double forceError = 0.0;                  // relative [-], of the field of interface forces
    std::vector<double> responseErrors = {};  // relative [-], of each response
  };

  /// `accuracy`: the relative error that is asked for [-], > 0. `responses`: how many there are.
  Calibration(double accuracy, std::size_t responses) : accuracy_(accuracy) {
    ratios_.responses.assign(responses, 1.0);
  }

  /// The smallest ratios over the states of one run.
  results::Ratios ratiosOf(const std::vector<Observation>& run) const;
  /// Those of one run more; true when a ratio fell, so that what was accepted must be looked at again.
  bool add(const results::Ratios& ofRun);
  /// Runs so far.
  int runs() const { return runs_; }
  /// kf and kc [-] of all runs.
  const results::Ratios& ratios() const { return ratios_; }

  /// E [-]; infinite before the first run.
  double estimate(const results::Indicators& indicators) const;
  /// What of E is about one response [-], by its number.
  double estimateOf(std::size_t response, const results::Indicators& indicators) const;
  /// True when E with its factor of safety, 1.5, or 2 before the fifth run, meets the accuracy.
  bool accepts(const results::Indicators& indicators) const;
  /// The largest indicators that it accepts.
  results::Indicators target() const;

 private:
  double accuracy_;
  int runs_ = 0;
  results::Ratios ratios_;
};

/// A target for what goes further: `share` of the smaller one of what was aimed at and of what was reached, indicator
/// by indicator; both of as many responses.
results::Indicators tightened(double share, const results::Indicators& aimed, const results::Indicators& reached);

}  // namespace harmos::parametric
