#pragma once

#include <memory>
#include <vector>

#include <harmos/latin/Snapshot.hpp>
#include <harmos/parametric/AcceptedResults.hpp>
#include <harmos/parametric/EarlierResult.hpp>
#include <harmos/parametric/StartRecord.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/results/ResultSink.hpp>

namespace harmos::parametric {

/// Solves a study in a random order until free indicators, calibrated in the same study, meet the accuracy.
///
/// Numbers 1, 2, 4, 8 and 16 calibrate: after their marches they are certified, far more accurately than asked for. So
/// are random ones after they were accepted, as audits. When a ratio falls, what it no longer covers is taken up again.
/// Configurations march from their neighbours where that has paid (StartRecord); the others, and those that lose their
/// way, get a certificate.
class CalibratedSchedule {
 public:
  /// `solver` must outlive it; its accuracy is what is met.
  explicit CalibratedSchedule(StudySolver& solver)
      : solver_(solver),
        calibration_(solver.options().accuracy, solver.responses().size()),
        delivery_(solver, calibration_),
        accepted_(calibration_, delivery_) {}

  CalibratedSchedule(const CalibratedSchedule&) = delete;

  /// What another run has learned and accepted, as if it had been this one; before run().
  void resume(const std::vector<EarlierResult>& earlier);
  /// Collective. Leaves early when interrupted; what is in flight is not recorded. Returns the configurations that are
  /// left because none could be had to calibrate: nothing can be said of them without a certificate.
  std::vector<design::Configuration> run(const std::vector<design::Configuration>& open, results::ResultSink& sink);

  /// How many configurations march side by side at most, if nothing else is asked for.
  static constexpr int usualWidest = 8;
  /// A march from neighbours ends after so many linear stages, or those of a cold start.
  static constexpr double stagesFromNeighbours = 20.0;
  /// How many march side by side once so many are solved, of at most `widest`.
  static int sideBySide(int solved, int widest);
  /// Sets the most that march side by side, at least 1.
  void setWidest(int widest) { widest_ = widest; }
  /// Calibrations that a study should have after so many configurations: numbers 1, 2, 4, 8 and 16 are.
  static int calibrationsUntil(int number);

 private:
  enum class Purpose { result, audit, calibration };
  /// What is under way of a configuration.
  struct Attempt {
    design::Configuration configuration;
    Purpose purpose;
    int place = 0;  // in the solver
    results::ConfigurationResult result = {};
    bool isOpen = false;  // neither inadmissible nor without equilibrium
    bool isFromNeighbours = false;
    bool isMarching = false;
    bool wasAudited = false;
    double distance = 0.0;    // to the nearest neighbour
    double cpuSeconds = 0.0;  // so far
    int stagesBefore = 0;     // when it was taken up before
  };

  Purpose purposeOfNext();
  /// How many configurations may march side by side now: none beside one that calibrates, and no more than a share of
  /// those that are solved.
  std::size_t mostTogether() const;
  int freePlace() const;
  void begin(const design::Configuration& configuration, Purpose purpose);
  /// Until one that marches is through.
  void march();
  /// Ends and records those that do not march; these return false when interrupted.
  bool endThose(results::ResultSink& sink);
  bool end(Attempt& attempt);
  /// From its neighbours, where that has paid, to an estimate that is accepted: the beginning, and what follows on the
  /// first march.
  void beginFromNeighbours(Attempt& attempt);
  bool endFromNeighbours(Attempt& attempt);
  bool calibrate(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Delivers the present state, and keeps it in mind.
  void accept(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Replaces the present state, which was accepted, by one that is certified more accurately; audits and calibrates.
  bool audit(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Certifies to a share of the accuracy from the present state, whose stages are added; what is thrown makes a
  /// failure.
  bool certifyFromHere(double share, results::ConfigurationResult& result);
  /// Calibrates with the way against the state certified last.
  void learn(results::ConfigurationResult& result);
  bool certifyAnew(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// After a ratio fell: estimates what was accepted anew, and opens again what is not covered any more.
  void reopen(results::ResultSink& sink);
  bool march(const results::Indicators& target, bool isToBeKept, results::ConfigurationResult& result);
  bool takeMarch(const results::Indicators& indicators, bool isToBeKept, results::ConfigurationResult& result);
  double limitFromNeighbours() const;

  StudySolver& solver_;
  int widest_ = usualWidest;
  Calibration calibration_;
  Delivery delivery_;
  int number_ = 0;    // of configurations that were new
  int attempts_ = 0;  // to calibrate
  AcceptedResults accepted_;
  std::vector<Attempt> underWay_;
  std::vector<design::Configuration> reopened_;  // of those accepted, to be taken up again
  StartRecord record_;
  bool isAuditDue_ = false;  // of the next configuration that is accepted
  bool ratioFell_ = false;
  results::Indicators indicators_;                           // of the present state
  std::vector<results::Indicators> way_;                     // of what calibrates: every state,
  std::vector<std::unique_ptr<latin::Snapshot>> snapshots_;  // and what is promised there
};

}  // namespace harmos::parametric
