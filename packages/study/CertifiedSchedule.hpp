#pragma once

#include <harmos/study/ResultSink.hpp>
#include <harmos/study/StudySolver.hpp>

namespace harmos::study {

/// Solves a study by a certificate for each configuration, in the order given, each from the nearest state known and
/// then, if need be, from a cold start.
class CertifiedSchedule {
 public:
  explicit CertifiedSchedule(StudySolver& solver) : solver_(solver) {}

  /// Leaves early when interrupted; what is in flight is not recorded.
  void run(const std::vector<Configuration>& open, ResultSink& sink);

 private:
  /// False when interrupted.
  bool solve(const Configuration& configuration, ConfigurationResult& result);

  StudySolver& solver_;
};

}  // namespace harmos::study
