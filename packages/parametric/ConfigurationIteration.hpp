#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Timers.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/parametric/Gauge.hpp>
#include <harmos/parametric/ReducedBasisStart.hpp>

namespace harmos::parametric {

/// The iteration of one configuration after another on the same operators: a march through the load steps, each from a
/// start made of solved states, with Anderson acceleration that already knows how the residual changes along them.
///
/// A load step whose start is good enough costs no solve; the others solve single columns, of what changes, so that
/// rough solves lose no digits. A stage of all load steps ends every march: it is the state that is delivered and whose
/// indicators are reported. Displacement form only.
class ConfigurationIteration {
 public:
  /// `neighbours`: solved states that a start is made of, at most. `memory`: differences that the acceleration keeps
  /// beyond those of the start. `accuracy`: relative one that fields have in the end [-], see
  /// FixedPoint::shareTractions(). `precision`: of the solves of single load steps. The phases "start", "indicators"
  /// and "acceleration" are charged to `timers`. All arguments must outlive it.
  ConfigurationIteration(latin::FixedPoint& fixedPoint,
                         const std::vector<std::shared_ptr<const latin::Response>>& responses, int neighbours,
                         int memory, double accuracy, substructure::Precision precision, base::Timers& timers);
  /// Asked on every rank before every load step; march() then goes on with the stage of all load steps at once.
  void setStop(std::function<bool()> mustStop) { mustStop_ = std::move(mustStop); }

  /// march() gives up after so many linear stages since begin(), see isLost(); they may end early within it.
  void setLimit(double stages) { limit_ = stages; }

  /// Collective. Begins the configuration whose laws are in the assembly, cold when there are only few `states`, which
  /// must stay as they are. `values`: of all parameters of the study, in their order.
  void begin(const SolvedStates& states, const std::vector<double>& values);
  /// Collective. Goes on from a state found elsewhere, with a stage of all load steps.
  Indicators beginAt(const base::Matrix& alpha);
  /// Collective. Iterates every load step until its share of the indicators is at most `target`, or a limit of
  /// iterations or that of setLimit() is reached, and then all of them once; the fields are those of state(). The first
  /// march since begin() ends at a load step that comes to a limit: the iteration isLost(), and has no state.
  Indicators march(const Indicators& target);
  /// Whether begin() must be called before anything else is asked: there may be no equilibrium, or no way to it from
  /// this start.
  bool isLost() const { return isLost_; }

  /// Linear stages since begin(), that for the loads included: solves of single load steps add up.
  int stages() const;
  /// ids of the configurations that the start came from.
  const std::vector<int>& starts() const { return starts_; }
  /// Fields of the last stage of all load steps; until the next application of the FixedPoint.
  const latin::Iterate& state() const {
    assert(state_ != nullptr && "no stage of all load steps has been made");
    return *state_;
  }
  /// Collective. What the responses may be at state(), see FixedPoint::indeterminacy().
  std::vector<latin::ResponseRange> ranges(const std::vector<std::shared_ptr<const latin::Response>>& responses);
  /// Collective. Why a law has no graph at state(), see latin::checkLaws(); empty: all have.
  std::string falseGraph();
  /// alpha [stress] of the last stage of all load steps, and its image under the linear part of the linear stage.
  const base::Matrix& alpha() const { return alpha_; }
  /// The latter: A alpha = beta - b [stress], rows of the layout x load steps; see SolvedStates.
  base::Matrix linear() const;
  /// What the response indicator is measured by [force].
  double force() const { return gauge_.force(); }

 private:
  void prepare();
  void updateOffset();
  Indicators applyAll();
  /// Iterates the load step that is selected, from its start; false where it does not meet the target.
  bool settle(int step, const Indicators& target);
  void findStart(int step, const Indicators& target);
  void extrapolate(int step);
  bool iterate(int step, const Indicators& target);
  /// The image of column_ once beta_ is known.
  void applyLaws();
  bool meets(int step, const Indicators& target);
  /// Solves of the present load step until a limit.
  int iterationsLeft() const;

  latin::FixedPoint& fixedPoint_;
  int neighbours_;
  double accuracy_;
  substructure::Precision precision_;
  base::Timers& timers_;
  Gauge gauge_;
  ReducedBasisStart start_;
  std::vector<latin::AndersonAcceleration> accelerations_;  // per load step
  std::function<bool()> mustStop_;
  base::Matrix alpha_, image_, beta_;         // of all load steps
  base::Matrix next_;                         // where the next stage of all load steps is made
  base::Matrix column_, columnImage_;         // alpha and T(alpha) of the present load step,
  base::Matrix columnBeta_, columnTraction_;  // beta and f^
  base::Matrix offset_;                       // image of alpha = 0
  const latin::Iterate* state_ = nullptr;     // of all load steps
  std::vector<base::Matrix> loads_, held_;    // of the bodies, for which the offset was computed
  bool isFirstMarch_ = true;
  bool isLost_ = false;
  double traction_ = 0.0;  // root mean square over the load steps of |f^|; when cold, over those so far
  double force_ = 0.0;     // what imbalances are measured by [force]; 0 before it is known
  double residual_ = 0.0;  // |T(alpha) - alpha| of the present load step
  std::vector<int> starts_;
  int stagesBefore_ = 0;
  double limit_ = std::numeric_limits<double>::infinity();  // of stages()
};

}  // namespace harmos::parametric
