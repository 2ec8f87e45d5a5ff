#pragma once

#include <map>
#include <memory>
#include <vector>

#include <harmos/latin/Snapshot.hpp>
#include <harmos/study/Calibration.hpp>
#include <harmos/study/ResultSink.hpp>
#include <harmos/study/StudySolver.hpp>

namespace harmos::study {

/// Solves a study in a random order until free indicators, calibrated in the same study, meet the accuracy.
///
/// Numbers 1, 2, 4, 8 and 16 are iterated on to a tight stop and calibrate, the first of them is certified as well; so
/// are random ones after they were accepted, as audits. When a ratio falls, what it no longer covers is taken up again.
/// An iteration that loses its way begins anew from a cold start, and then with a certificate.
class CalibratedSchedule {
 public:
  explicit CalibratedSchedule(StudySolver& solver) : solver_(solver), calibration_(solver.options().accuracy) {}

  /// Leaves early when interrupted; what is in flight is not recorded. Returns the configurations that are left because
  /// a certificate has contradicted the calibration: nothing can be said of them without one.
  std::vector<Configuration> run(const std::vector<Configuration>& open, ResultSink& sink);

 private:
  /// What an accepted configuration was accepted with.
  struct Accepted {
    Configuration configuration;
    ConfigurationResult result;
    Indicators indicators;
  };
  enum class Purpose { result, audit, calibration };

  Purpose purposeOfNext();
  int stageLimit() const;
  /// These return false when interrupted.
  bool solve(const Configuration& configuration, Purpose purpose, ResultSink& sink);
  bool attempt(const Configuration& configuration, Purpose purpose, ConfigurationResult& result);
  bool iterate(const Configuration& configuration, Purpose purpose, const SolvedStates& states,
               ConfigurationResult& result);
  /// Iterates on from the present state, whose way so far is in `snapshots_`, to a tight stop and calibrates; audits.
  bool tighten(Purpose purpose, ConfigurationResult& result);
  bool isTight() const;
  /// Whether the present state is good enough to audit with.
  bool isReference() const;
  void calibrate(Purpose purpose);
  /// Audits with the solution of a certificate, where the iteration has come to no tight stop.
  bool refer(const latin::Snapshot& claimed, ConfigurationResult& result);
  void record(const latin::Snapshot& reference, double uncertainty, const latin::Snapshot& claimed);
  /// Certifies the present tight state; what calibrates must not contradict a certificate.
  bool confirm(ConfigurationResult& result);
  bool reopen(ResultSink& sink);
  bool march(const Indicators& target, bool isToBeKept, ConfigurationResult& result);

  void deliver(ConfigurationResult& result) const;
  void estimate(const Indicators& indicators, ConfigurationResult& result) const;

  StudySolver& solver_;
  Calibration calibration_;
  int number_ = 0;                    // of configurations that were new
  int attempts_ = 0;                  // to calibrate
  bool isContradicted_ = false;       // by a certificate
  std::map<int, Accepted> accepted_;  // by id
  std::vector<int> stagesOfAccepted_;
  bool ratioFell_ = false;
  Indicators indicators_;                                    // of the present state
  std::vector<Indicators> way_;                              // of a run that calibrates: every state,
  std::vector<std::unique_ptr<latin::Snapshot>> snapshots_;  // and what is promised there
};

}  // namespace harmos::study
