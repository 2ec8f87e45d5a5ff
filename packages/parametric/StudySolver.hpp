#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Teuchos_RCP.hpp>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Timers.hpp>
#include <harmos/design/Configuration.hpp>
#include <harmos/latin/LatinSolver.hpp>
#include <harmos/parametric/ConfigurationIteration.hpp>
#include <harmos/parametric/SolvedStates.hpp>
#include <harmos/parametric/Trust.hpp>
#include <harmos/results/ConfigurationResult.hpp>

namespace harmos::parametric {

/// What all ways of solving a study share: the operators, how a configuration is put on them and certified, and the
/// states that were found. All calls are collective over the communicator.
class StudySolver {
 public:
  /// Memory [byte] that states may take on a rank, the same on all.
  static constexpr double memoryForStates = 160.0 * 1024.0 * 1024.0;
  /// Puts the laws for these parameter values into the assembly; throws base::Error when they are inadmissible.
  using Install = std::function<void(const std::vector<double>& values)>;
  /// Told the fields of every solution, also of one that replaces an earlier one. Nobody needs them afterwards: it may
  /// go on with the FixedPoint that they are of, whose laws are the configuration's.
  using Observer = std::function<void(const design::Configuration&, latin::FixedPoint&, const latin::Iterate&)>;

  /// Factors all operators. `assembly` and `timers` must outlive this object. Throws base::Error as
  /// latin::LatinSolver.
  StudySolver(assembly::Assembly& assembly, Install install,
              std::vector<std::shared_ptr<const latin::Response>> responses, const latin::LatinOptions& options,
              const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);

  /// Asked on every rank between iterations; true on any rank makes mustStop().
  void setInterrupt(std::function<bool()> interrupted) {
    interrupted_ = interrupted;
    solver_.setInterrupt(std::move(interrupted));
  }
  /// Replaces the observer; it may be empty.
  void setObserver(Observer observer) { observer_ = std::move(observer); }
  /// What all ranks make of the interrupt. Collective.
  bool mustStop() const { return solver_.mustStop(); }

  /// Empties the result and installs the laws; false, with the reason in the result, when they are inadmissible.
  bool install(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Parameters are measured by the range of what they are in a study: to be called for all its configurations.
  void widen(const std::vector<double>& values);
  /// Asks rigid statics of all load steps, without any iteration, whether the configuration that is installed has for
  /// certain no equilibrium; true, with the reason in the result, where it has none. Collective.
  bool lacksEquilibrium(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Whether one of those that lacksEquilibrium() has found is nearer than any that is solved.
  bool isNearLack(const design::Configuration& configuration) const;
  /// Solves the configuration that is installed until corrections of its own bound its error by `share` of the
  /// accuracy, from `start` if it is not null. Adds what it took to the result. False when interrupted.
  bool certify(const base::Matrix* start, results::ConfigurationResult& result, double share = 1.0);
  /// The same, from nothing that may mislead; what is thrown makes a failure. A solution is remembered. Where none is
  /// found the configuration is solved alone, as a run would, with operators of its own: with softer search directions,
  /// and from reference motions, which others could not start from; this one is not remembered.
  bool certifyAnew(const design::Configuration& configuration, results::ConfigurationResult& result);
  /// Stores what was iterated last for the starts of others, and shows it to the observer.
  void remember(const design::Configuration& configuration);
  /// The same of what was certified last; in the displacement form a stage of its own, which is added to the result,
  /// finds its image.
  void rememberCertified(const design::Configuration& configuration, results::ConfigurationResult& result);

  /// As they were given.
  const latin::LatinOptions& options() const { return given_; }
  /// As they were given, in their order.
  const std::vector<std::shared_ptr<const latin::Response>>& responses() const { return responses_; }
  /// The fields of what was iterated or certified last.
  const latin::FixedPoint& fixedPoint() const { return fixedPoint_; }
  /// Fields that certify() has left.
  const latin::Iterate& certifiedState() const { return solver_.state(); }
  /// How the present configuration is iterated: that of the place of keep() or present() last, of place 0 before.
  ConfigurationIteration& iteration() { return *places_[present_].iteration; }

  /// Gives the configuration that was installed last a place, from 0, among those that march side by side; its
  /// iteration() must begin anew.
  void keep(int place);
  /// Makes the configuration of a place the present one again, as if it was installed.
  void present(int place);
  /// How far a configuration has come.
  struct Marched {
    bool waits;         ///< for march() to lead it on
    std::string error;  ///< that it has thrown as base::Error; empty: none
  };
  /// Collective. Leads the configurations of these places on, until one of them is through all load steps, up to
  /// endMarch(), or has thrown.
  std::vector<Marched> march(const std::vector<int>& places);
  /// What remember() has stored: as many as fit into memoryForStates on every rank.
  SolvedStates& states() { return states_; }
  /// Where the schedules count.
  Trust& summary() { return summary_; }

 private:
  using Laws = std::vector<std::shared_ptr<const laws::InterfaceLaw>>;
  /// Of a configuration that marches beside others.
  struct Place {
    std::unique_ptr<ConfigurationIteration> iteration;
    Laws laws;  // of all interfaces
  };

  /// Puts a solution into the result; false when interrupted.
  bool take(const latin::LatinResult& solution, results::ConfigurationResult& result);
  /// Solves the configuration that is installed with the options that were given.
  bool certifyAlone(const design::Configuration& configuration, results::ConfigurationResult& result);
  void observe(const design::Configuration& configuration, const latin::Iterate& state);
  void addPlace();
  void putLaws(const Place& place);

  assembly::Assembly& assembly_;
  Install install_;
  std::vector<std::shared_ptr<const latin::Response>> responses_;
  latin::LatinOptions given_;
  latin::LatinOptions options_;  // for operators that configurations share
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  base::Timers& timers_;
  latin::LatinSolver solver_;
  latin::FixedPoint& fixedPoint_;
  StepSolver stepSolver_;
  std::vector<Place> places_;
  int present_ = 0;
  SolvedStates states_;
  SolvedStates lacking_;  // of configurations that statics leaves without equilibrium; without fields
  Observer observer_;
  std::function<bool()> interrupted_;
  Trust summary_;
};

/// CPU time of this process [s].
double cpuSeconds();

}  // namespace harmos::parametric
