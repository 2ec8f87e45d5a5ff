#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <Teuchos_RCP.hpp>

#include <harmos/base/Timers.hpp>
#include <harmos/interface/Assembly.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/study/Calibration.hpp>
#include <harmos/study/Configuration.hpp>
#include <harmos/study/ConfigurationIteration.hpp>
#include <harmos/study/ConfigurationResult.hpp>
#include <harmos/study/ResultSink.hpp>
#include <harmos/study/SolvedStates.hpp>
#include <harmos/study/StudySummary.hpp>

namespace harmos::study {

/// Solves the configurations of a study on operators that are factored once.
///
/// A configuration changes laws only: friction, preload, stiffness of interfaces, prescribed displacements and
/// tractions. The configurations are taken in a random order, each started from the span of its nearest neighbours
/// (ReducedBasisStart) and iterated until its free indicators, calibrated in the same study, meet the accuracy
/// (Calibration). Numbers 1, 2, 4, 8 and 16 are iterated on to a tight stop and calibrate, the first of them is
/// certified as well; so are random ones after they were accepted, as audits. When a ratio falls, what it no longer
/// covers is taken up again. An iteration that loses its way begins anew from a cold start, and then with a
/// certificate. The accuracy is that of the responses and of the field of interface forces. Studies of fewer than 10
/// configurations, the velocity form and the algorithms of the literature get a certificate for each configuration. All
/// calls are collective over the communicator.
class ParametricStudy {
 public:
  /// Puts the laws for these parameter values into the assembly; throws base::Error when they are inadmissible.
  using Install = std::function<void(const std::vector<double>& values)>;

  /// Factors all operators. `assembly` and `timers` must outlive this object.
  ParametricStudy(interface::Assembly& assembly, Install install,
                  std::vector<std::shared_ptr<const latin::Response>> responses, const latin::LatinOptions& options,
                  const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);

  /// Asked on every rank between iterations; when it is true on any rank, run() leaves at once and what is in flight is
  /// not recorded.
  void setInterrupt(std::function<bool()> interrupted);

  /// Called on every rank with the fields of every solution, also of one that replaces an earlier one.
  void setObserver(std::function<void(const Configuration&, const latin::FixedPoint&)> observer) {
    observer_ = std::move(observer);
  }

  /// Solves all of `open`. `sink` is called on every rank; a configuration may be reported again when its estimate or
  /// its solution has changed. What is solved serves later calls as well.
  void run(const std::vector<Configuration>& open, ResultSink& sink);
  /// Of all calls of run() together.
  const StudySummary& summary() const { return summary_; }

 private:
  /// What an accepted configuration was accepted with.
  struct Accepted {
    Configuration configuration;
    ConfigurationResult result;
    Indicators indicators;
  };
  enum class Purpose { result, audit, calibration };

  void certifyEach(const std::vector<Configuration>& open, ResultSink& sink);
  /// These return false when interrupted.
  bool solve(const Configuration& configuration, bool isNew, ResultSink& sink);
  bool iterate(const Configuration& configuration, Purpose purpose, const SolvedStates& states,
               ConfigurationResult& result);
  /// Iterates on from the present state, whose way so far is in `snapshots_`, to a tight stop and calibrates.
  bool tighten(Purpose purpose, ConfigurationResult& result);
  /// Certifies the present tight state; what calibrates must not contradict a certificate.
  bool confirm(ConfigurationResult& result);
  bool certify(const base::Matrix* start, ConfigurationResult& result);
  bool reopen(ResultSink& sink);

  Purpose purposeOfNext();
  void deliver(const Indicators& indicators, ConfigurationResult& result) const;
  void estimate(const Indicators& indicators, ConfigurationResult& result) const;
  void remember(const Configuration& configuration);
  void observe();
  int stageLimit() const;

  Install install_;
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  latin::LatinOptions options_;
  latin::LatinSolver solver_;
  latin::FixedPoint& fixedPoint_;
  ConfigurationIteration iteration_;
  std::function<void(const Configuration&, const latin::FixedPoint&)> observer_;

  Calibration calibration_;
  SolvedStates states_;
  int number_ = 0;                    // of configurations that were new to solve()
  int attempts_ = 0;                  // to calibrate
  bool isContradicted_ = false;       // by a certificate: then each configuration is certified
  std::map<int, Accepted> accepted_;  // by id
  std::vector<int> stagesOfAccepted_;
  bool ratioFell_ = false;
  Indicators indicators_;                                    // of the present state
  std::vector<Indicators> way_;                              // of a run that calibrates: every state,
  std::vector<std::unique_ptr<latin::Snapshot>> snapshots_;  // and what is promised there
  StudySummary summary_;
};

}  // namespace harmos::study
