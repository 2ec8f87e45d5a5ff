#pragma once

#include <harmos/parametric/StudySolver.hpp>
#include <harmos/results/ResultSink.hpp>

namespace harmos::parametric {

/// Solves a study by a certificate for each configuration, in the order given, each from the nearest state known and
/// then, if need be, from a cold start.
class CertifiedSchedule {
 public:
  /// `solver` must outlive it.
  explicit CertifiedSchedule(StudySolver& solver) : solver_(solver) {}

  /// Collective. Leaves early when interrupted; what is in flight is not recorded.
  void run(const std::vector<design::Configuration>& open, results::ResultSink& sink);

 private:
  /// False when interrupted.
  bool solve(const design::Configuration& configuration, results::ConfigurationResult& result);

  StudySolver& solver_;
};

}  // namespace harmos::parametric
