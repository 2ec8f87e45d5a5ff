#pragma once

#include <cassert>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <harmos/base/SoleThread.hpp>
#include <harmos/latin/Certificate.hpp>
#include <harmos/latin/IterationReport.hpp>
#include <harmos/latin/LatinOptions.hpp>
#include <harmos/latin/LatinResult.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/latin/March.hpp>
#include <harmos/latin/Response.hpp>

/// The LATIN iteration: local stage, linear stage, acceleration, error estimates and responses.
namespace harmos::latin {

/// Solves an assembly by LATIN to a certified accuracy.
///
/// By default follows the load steps one after the other (March), then asks the Certificate; if that does not claim,
/// marches on to a smaller residual. The iterations of the literature and the velocity form iterate
/// alpha <- T(alpha) over all load steps until the promised quantities have settled. All calls are collective over the
/// communicator.
class LatinSolver {
 public:
  /// Factors all operators. `assembly` and `timers` must outlive the solver. Throws base::Error (input) on every rank
  /// that lists what is wrong with the assembly, see assembly::demandValid(), or with the options; base::Error naming
  /// the part when an operator is singular or nothing holds the assembly.
  LatinSolver(const assembly::Assembly& assembly, const LatinOptions& options,
              const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);

  /// Adds a response whose accuracy is promised as well, and shares it. To be called before solve().
  void addResponse(std::shared_ptr<const Response> response) { responses_.push_back(std::move(response)); }
  /// Called on every rank after every iteration; after every load step of a march, when state() holds only that one.
  void addObserver(std::function<void(const IterationReport&)> observer) { observers_.push_back(std::move(observer)); }
  /// Asked on every rank after every iteration; the run stops when it is true on any rank.
  void setInterrupt(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }
  /// Collective. What all ranks make of it.
  bool mustStop() const;

  /// Of the runs to come, in the place of that of the options: relative [-], > 0.
  void setAccuracy(double accuracy) { options_.accuracy = accuracy; }
  /// Runs from alpha = 0, or from `start` (rows as in the layout), which may be alpha().
  LatinResult solve(const base::Matrix* start = nullptr);
  /// Fields of the delivered state, or to an observer those of the present one; until the next application of
  /// fixedPoint(). To be asked after a solve() only.
  const Iterate& state() const {
    assert(state_ != nullptr && "nothing has been solved");
    return *state_;
  }
  /// The iteration itself, for those who go on from here.
  FixedPoint& fixedPoint() { return fixedPoint_; }
  /// The delivered state alpha [stress]: a start for another run, or a checkpoint.
  const base::Matrix& alpha() const { return fixedPoint_.reference().isEmpty() ? alpha_ : whole_; }

 private:
  /// While a thread is inside.
  LatinSolver(const base::SoleThread& inside, const assembly::Assembly& assembly, const LatinOptions& options,
              const Teuchos::RCP<const Teuchos::Comm<int>>& comm, base::Timers& timers);
  void deliver(LatinResult& result);
  /// Where pressures are free: extends the ranges of responses by what other solutions say, if any are found, and adds
  /// the linear stages that it takes.
  void lookForOthers(LatinResult& result, Indeterminacy& found);
  /// Gives the iterate of alpha_ the tractions that are defined where bodies feel only their sum; lets go of image_.
  void share();
  /// Takes a certificate back where a law answers the lines of other search directions otherwise, see checkLaws().
  void demandGraphs(LatinResult& result);
  /// Load step after load step; where restarts of the march lead nowhere, from the beginning with the softer search
  /// direction that they begin with, and from nothing at every load step, unless laws soften or loads are to be found;
  /// where that leads nowhere either, as at first without restarts.
  void march(LatinResult& result, March::Guess guess);
  /// Collective. The residual that the first march goes to, over the size of the forces.
  double firstTolerance() const;
  /// One try: marches to ever smaller residuals, until the certificate claims, or too little has come of them and
  /// another try is left.
  void tryToMarch(LatinResult& result, March::Guess guess, int restarts);
  /// Whether the search direction is softer now than the options want it.
  bool isSofter() const;
  /// Linear stages of this run, at most: of the run, or of a try with a softer search direction.
  int stageLimit() const;
  /// All load steps at once; see SimultaneousIteration.
  void iterate(LatinResult& result);
  /// Tells all observers of an iterate.
  void observe(const Iterate& iterate, const IterationReport& report);
  /// Tries for a certificate of alpha_, whose iterate is given; true when that is the end of the run: it claims, or
  /// round-off forbids it for ever. Leaves its corrected state in alpha_.
  bool certify(const Iterate& iterate, LatinResult& result);
  /// Collective. Where loads that are small beside those of other load steps act on parts that nothing holds in this
  /// iterate of alpha_, their way to what would hold them is no error that the residual shows: makes the tolerance of
  /// the next march so small that these loads count, and begins their load steps from nothing, once. Whether that is
  /// so.
  bool bringBack(const Iterate& iterate, double& tolerance);
  /// Collective. Takes the certificate back where bringBack() is needed: then it is false.
  bool isHeldByItsLoads(LatinResult& result, double& tolerance);
  /// Estimates round-off in alpha_, whose iterate is given or null, and adds it to the estimates; true when the sum is
  /// within the accuracy. Says in `result` if round-off is too much for another attempt, unless this one is claimed.
  bool standsRoundOff(const Iterate* iterate, bool isClaimed, LatinResult& result);
  /// Takes back all that a try has come to, for another one with so many times the search direction of the options.
  void beginAnew(LatinResult& result, double times);
  /// Forgets an outcome, and what is known of round-off, before the run goes on with other states.
  void takeBack(LatinResult& result);
  /// Names of the promised quantities, as Snapshot::distance() has them.
  std::vector<std::string> quantities() const;
  /// Counts displacements from the rigid motions of bodies in alpha_; the certificate begins anew.
  void recentre();
  int stages() const { return fixedPoint_.linearStage().stages() - stagesBefore_; }

  const assembly::Assembly& assembly_;
  LatinOptions options_;
  base::Timers& timers_;
  FixedPoint fixedPoint_;
  std::vector<std::shared_ptr<const Response>> responses_;
  std::vector<std::function<void(const IterationReport&)>> observers_;
  std::optional<StepNewton> newton_;        // of this run
  std::optional<LoadBalance> balance_;      // of the laws and loads of this solve()
  std::optional<March::Slide> slide_;       // of a load step that no try has solved
  std::optional<Certificate> certificate_;  // of this run: keeps its directions from one attempt to the next
  std::function<bool()> interrupted_;
  base::Matrix alpha_;
  base::Matrix image_;
  base::Matrix whole_;  // alpha_ of whole displacements, where they are counted from reference motions
  const Iterate* state_ = nullptr;
  const Iterate* certified_ = nullptr;  // of alpha_, where the certificate has left it at hand
  int stagesBefore_ = 0;
  int stagesOfCertificates_ = 0;
  int endWhenSofter_ = 0;       // linear stages at which a try ends, once its search direction is softer
  bool knowsRoundOff_ = false;  // of a state of this run
  bool isBroughtBack_ = false;  // the state of parts that nothing held against their loads, in this run
  std::optional<std::vector<std::string>> unheldParts_;  // remarks on the last state that was looked at; none: none was
  std::vector<double> estimates_;                        // of the last certificate that was conclusive; empty: none was
};

}  // namespace harmos::latin
