#pragma once

#include <harmos/parametric/Calibration.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/results/ConfigurationResult.hpp>

namespace harmos::parametric {

/// Writes down what a configuration of a study has come to that was accepted by its calibrated indicators.
class Delivery {
 public:
  /// Both must outlive it.
  Delivery(StudySolver& solver, const Calibration& calibration) : solver_(solver), calibration_(calibration) {}

  /// Collective, after a stage of all load steps with these indicators. Curves, estimates, status and reason of the
  /// present configuration; not converged where its state is on no graph of the laws. Throws base::Error as laws do.
  void deliver(const results::Indicators& indicators, results::ConfigurationResult& result) const;
  /// The estimates alone, of the result [-] and of its curves.
  void estimate(const results::Indicators& indicators, results::ConfigurationResult& result) const;

 private:
  /// Adds to the reason which responses the problem does not determine; true when it determines all.
  bool addRanges(results::ConfigurationResult& result) const;

  StudySolver& solver_;
  const Calibration& calibration_;
};

}  // namespace harmos::parametric
