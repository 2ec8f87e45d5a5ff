#pragma once

#include <harmos/results/Evidence.hpp>

namespace harmos::parametric {

/// How far the results of a study can be trusted; see Calibration.
struct Trust {
  int calibrations = 0;          // configurations that were iterated on to a tight stop to calibrate the estimate
  results::Ratios ratios = {};   // see Calibration
  int audits = 0;                // accepted configurations, chosen at random, that were iterated on or certified
  int openAudits = 0;            // others that came to no end, so that nothing is known of their errors
  int falseClaims = 0;           // audited configurations whose error was above the accuracy
  double largestAudit = 0.0;     // largest error found by an audit, its own uncertainty added, over the accuracy
  double falseClaimBound = 1.0;  // upper limit of the share of false claims at 95 % confidence, from the audits
  int reopened = 0;              // accepted configurations that were taken up again when a ratio fell
  int certificates = 0;          // configurations that were certified by corrections of their own

  /// Counts an audit that found this error [-], over the accuracy.
  void addAudit(double error);
};

/// Largest share p of false claims for which `found` or fewer among `audits` have a probability of 5 % or more
/// (Clopper and Pearson); 1 without audits, and when all were found.
double falseClaimBound(int audits, int found);

}  // namespace harmos::parametric
