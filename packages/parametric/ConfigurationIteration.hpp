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
#include <harmos/parametric/StepSolver.hpp>

namespace harmos::parametric {

/// The iteration of one configuration after another on the same operators: a march through the load steps, each from a
/// start made of solved states, with Anderson acceleration that already knows how the residual changes along them.
///
/// A load step whose start is good enough costs no solve; the others solve single columns, of what changes, so that
/// rough solves lose no digits. A stage of all load steps ends every march: it is the state that is delivered and whose
/// indicators are reported. Displacement form only.
class ConfigurationIteration {
 public:
  /// How many are remembered at most: solved states that a start is made of; changes that were solved for, along which
  /// load steps go on that are slow, 0: they do with the states alone; and differences of the acceleration beyond
  /// these.
  struct Remembered {
    int neighbours = 0, changes = 0, differences = 0;
  };

  /// `accuracy`: relative one that fields have in the end [-], see
  /// FixedPoint::shareTractions(). `solver`: of single load steps of `fixedPoint`. The phases "start", "indicators"
  /// and "acceleration" are charged to `timers`. All arguments must outlive it.
  ConfigurationIteration(latin::FixedPoint& fixedPoint, StepSolver& solver,
                         const std::vector<std::shared_ptr<const latin::Response>>& responses,
                         const Remembered& remembered, double accuracy, base::Timers& timers);
  /// Asked on every rank before every solve; march() then goes on with the stage of all load steps at once.
  void setStop(std::function<bool()> mustStop) { mustStop_ = std::move(mustStop); }

  /// What a load step of the first march that comes to a limit means: that the iteration isLost(), or that this load
  /// step and those that follow are taken as far as they have come.
  enum class AtLimit { isLost, goesOn };
  /// march() iterates no longer after so many linear stages since begin(); they may end early within it.
  void setLimit(double stages, AtLimit meaning = AtLimit::isLost) {
    limit_ = stages;
    atLimit_ = meaning;
  }

  /// Collective. Begins the configuration whose laws are in the assembly, cold when there are only few `states`.
  /// `values`: of all parameters of the study, in their order.
  void begin(const SolvedStates& states, const std::vector<double>& values);
  /// Collective. Goes on from a state found elsewhere, with a stage of all load steps.
  results::Indicators beginAt(const base::Matrix& alpha);
  /// Collective. Iterates every load step until its share of the indicators is at most `target`, or a limit of
  /// iterations or that of setLimit() is reached, and then all of them once; the fields are those of state(). An
  /// iteration that isLost() has no state.
  results::Indicators march(const results::Indicators& target);

  /// march() in pieces, so that others may march beside it. Begins it; until endMarch(), proceed() wants the laws of
  /// begin() in the assembly.
  void startMarch(const results::Indicators& target);
  /// Collective. Goes on until a column has to be solved, then returns true: once request() is solved, markSolved()
  /// must be called before the next proceed() goes on. False when the march is through all load steps or lost.
  bool proceed();
  /// What has to be solved; valid until the next proceed().
  StepSolver::Request request();
  /// The request is solved.
  void markSolved() { isSolved_ = true; }
  /// Collective, with the loads of begin() on the operators. The stage of all load steps, unless the march is lost.
  results::Indicators endMarch();

  /// Whether begin() must be called before anything else is asked: there may be no equilibrium, or no way to it from
  /// this start.
  bool isLost() const { return isLost_; }

  /// Linear stages since begin(), that for the loads included: solves of single load steps add up, and are rounded.
  int stages() const;
  /// ids of the configurations that the start came from.
  const std::vector<int>& starts() const { return starts_; }
  /// Fields of the last stage of all load steps; until the next application of the FixedPoint.
  const latin::Iterate& state() const {
    assert(state_ != nullptr && "no stage of all load steps has been made");
    return *state_;
  }
  /// Collective. What is not determined at state(), see FixedPoint::indeterminacy().
  latin::Indeterminacy indeterminacy(const std::vector<std::shared_ptr<const latin::Response>>& responses);
  /// Collective. Why a law has no graph at state(), see latin::lackOfGraph(); empty: all have.
  std::string falseGraph();
  /// alpha [stress] of the last stage of all load steps, and its image under the linear part of the linear stage.
  const base::Matrix& alpha() const { return alpha_; }
  /// The latter: A alpha = beta - b [stress], rows of the layout x load steps; see SolvedStates.
  base::Matrix linear() const;
  /// What indicators are measured by [force], see Gauge::forces().
  const std::vector<double>& forces() const { return gauge_.forces(); }

 private:
  void prepare();
  results::Indicators applyAll();
  /// Finds the start of the present load step.
  void startStep();
  void findStart();
  /// Gives the acceleration the columns of the start with their tangents.
  void seed();
  /// Goes to less residual at the present load step without a solve, where that is not far away.
  void improve();
  /// Begins the acceleration anew: from less residual, where that can be had without a solve, with the tangents there.
  void beginAnew();
  /// Notes the residual of the present load step; whether it has not fallen as it should.
  bool isSlow();
  void extrapolate();
  /// Finds what column_ changes by next.
  void propose();
  /// Keeps what the present load step has come to, and goes on to the next one.
  void endStep();
  /// A solved change.
  void take();
  /// The image of column_ once columnBeta_ is known.
  void applyLaws();
  bool meetsTarget();
  /// Solves of the present load step until a limit.
  int iterationsLeft() const;

  latin::FixedPoint& fixedPoint_;
  StepSolver& solver_;
  latin::PointwiseLocalStage local_;  // of its own, with the histories of its march
  Remembered remembered_;
  double accuracy_;
  base::Timers& timers_;
  Gauge gauge_;
  ReducedBasisStart start_;
  latin::AndersonAcceleration acceleration_;  // of the present load step
  std::function<bool()> mustStop_;
  base::Matrix alpha_, image_, beta_;           // of all load steps
  base::Matrix next_;                           // where the next stage of all load steps is made
  base::Matrix column_, columnImage_;           // alpha and T(alpha) of the present load step,
  base::Matrix columnBeta_, columnTraction_;    // beta and f^
  base::Matrix change_, changeImage_;           // what column_ has changed by, and A times it
  std::shared_ptr<const base::Matrix> offset_;  // image of alpha = 0
  const latin::Iterate* state_ = nullptr;       // of all load steps
  bool isFirstMarch_ = true;
  bool isLost_ = false;
  results::Indicators target_;                 // of the present march,
  int step_ = 0;                               // its load step
  bool isStarted_ = false;                     // which has a start
  bool isWaiting_ = false, isSolved_ = false;  // for the solve of a change, and whether it is there
  bool isThere_ = false;                       // and meets the target
  int iterations_ = 0, mostIterations_ = 0;    // at the present load step
  bool wasSlow_ = false;                       // there
  std::vector<double> residuals_;              // of them since the last restart of the acceleration
  double traction_ = 0.0;       // root mean square over the load steps of |f^|; when cold, over those so far
  std::vector<double> forces_;  // what indicators are measured by [force]; empty before it is known
  double residual_ = 0.0;       // |T(alpha) - alpha| of the present load step
  std::vector<int> starts_;
  long columns_ = 0;                                        // solved since begin()
  double limit_ = std::numeric_limits<double>::infinity();  // of stages()
  AtLimit atLimit_ = AtLimit::isLost;
};

}  // namespace harmos::parametric
