#pragma once

#include <map>
#include <memory>
#include <vector>

#include <harmos/latin/Snapshot.hpp>
#include <harmos/parametric/Calibration.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/results/ResultSink.hpp>

namespace harmos::parametric {

/// Solves a study in a random order until free indicators, calibrated in the same study, meet the accuracy.
///
/// Numbers 1, 2, 4, 8 and 16 are iterated on to a tight stop and calibrate, the first of them is certified as well; so
/// are random ones after they were accepted, as audits. When a ratio falls, what it no longer covers is taken up again.
/// An iteration that loses its way begins anew from a cold start, and then with a certificate.
class CalibratedSchedule {
 public:
  /// `solver` must outlive it; its accuracy is what is met.
  explicit CalibratedSchedule(StudySolver& solver) : solver_(solver), calibration_(solver.options().accuracy) {}

  /// Collective. Leaves early when interrupted; what is in flight is not recorded. Returns the configurations that are
  /// left because a certificate has contradicted the calibration: nothing can be said of them without one.
  std::vector<design::Configuration> run(const std::vector<design::Configuration>& open, results::ResultSink& sink);

 private:
  /// What an accepted configuration was accepted with.
  struct Accepted {
    design::Configuration configuration;
    results::ConfigurationResult result;
    Indicators indicators;
  };
  enum class Purpose { result, audit, calibration };

  Purpose purposeOfNext();
  int stageLimit() const;
  /// These return false when interrupted.
  bool solve(const design::Configuration& configuration, Purpose purpose, results::ResultSink& sink);
  bool attempt(const design::Configuration& configuration, Purpose purpose, results::ConfigurationResult& result);
  bool iterate(const design::Configuration& configuration, Purpose purpose, const SolvedStates& states,
               results::ConfigurationResult& result);
  /// Iterates on from the present state, whose way so far is in `snapshots_`, to a tight stop and calibrates; audits.
  bool tighten(Purpose purpose, results::ConfigurationResult& result);
  bool isTight() const;
  /// Whether the present state is good enough to audit with.
  bool isReference() const;
  void calibrate(Purpose purpose);
  /// Audits with the solution of a certificate, where the iteration has come to no tight stop.
  bool refer(const latin::Snapshot& claimed, results::ConfigurationResult& result);
  void record(const latin::Snapshot& reference, double uncertainty, const latin::Snapshot& claimed);
  /// Certifies the present tight state; what calibrates must not contradict a certificate.
  bool confirm(results::ConfigurationResult& result);
  bool reopen(results::ResultSink& sink);
  bool march(const Indicators& target, bool isToBeKept, results::ConfigurationResult& result);

  void deliver(results::ConfigurationResult& result);
  /// Adds to the reason which responses the problem does not determine; true when it determines all.
  bool addRanges(results::ConfigurationResult& result);
  void estimate(const Indicators& indicators, results::ConfigurationResult& result) const;

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

}  // namespace harmos::parametric
