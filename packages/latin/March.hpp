#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/EquilibriumWatch.hpp>
#include <harmos/latin/LoadBalance.hpp>
#include <harmos/latin/StepNewton.hpp>

namespace harmos::latin {

struct MarchStep;
class SofteningSteps;

/// Iterates one load step after the other, each with the history that the one before has left.
///
/// What a step does then depends on nothing that is still moving, which is faster and far surer along paths with
/// friction than to iterate all load steps at once. Each step iterates with Anderson acceleration until |T(alpha) -
/// alpha| <= tolerance |f^| in the state metric, |f^| the largest of the steps so far. Bodies that fly freely are set
/// down on what stops them (EquilibriumWatch), relaxed iterations help to find them. Where a step stagnates, StepNewton
/// is tried, by Newton's method and in pseudo-time. When both fail, the search direction k was too stiff for what the
/// bodies do (sliding, hanging on soft springs): the march goes on with a tenth of it, at most `restarts` times, unless
/// the tolerance is so small that round-off may be why. Neither where all laws are affine, for then the acceleration is
/// a Krylov method. Where laws soften, Newton's method comes first (SofteningSteps), and a step that cannot be
/// solved ends the march: those after it would follow on nothing. Bodies are solved in single precision as long as its
/// error is far below the residual. Displacement form only.
class March {
 public:
  /// How a march ended.
  enum class End {
    reached,        ///< all load steps were visited
    stopped,        ///< the caller asked to stop
    noEquilibrium,  ///< see reason()
    unreached,      ///< a load step with laws that soften could not be solved, see reason()
  };
  /// A load step at which a joint slides on and on, and what it lacks, in words for the user.
  struct Slide {
    int step;
    std::string reason;
  };
  /// How the next load step starts.
  enum class Guess {
    extrapolation,  ///< from the two steps before it
    nothing,        ///< from alpha = 0
    state           ///< from what alpha holds for it
  };

  /// Iterations of a load step, after its last landing, by which it is left as it is.
  static constexpr int maximumIterations = 100;
  /// Of the residual from one march to the next, when what has come of the first is not enough.
  static constexpr double tightening = 0.1;

  /// Of the search direction, at a restart.
  static constexpr double softer = 0.1;

  /// `fixedPoint` must outlive it. `memory` of the acceleration; loads that are not carried are those above `accuracy`.
  March(FixedPoint& fixedPoint, int memory, double accuracy, int restarts);
  ~March();
  March(const March&) = delete;
  March& operator=(const March&) = delete;

  /// Asked before every load step whether its loads can be balanced at all; must outlive it.
  void setLoadBalance(LoadBalance& balance) { balance_ = &balance; }
  /// Whether load steps are left as soon as their forces are lost in k w, see lacksDigits(); at first they are not.
  void setLeavesWithoutDigits(bool leaves) { leavesWithoutDigits_ = leaves; }
  /// The last run has left a load step because its forces are so small beside k w that round-off would spoil them:
  /// displacements should be counted from the motion of the bodies that it has found, see FixedPoint::recentre().
  bool lacksDigits() const { return lacksDigits_; }
  /// What helps load steps that stagnate; must outlive it. Without it there is no such help.
  void setNewton(StepNewton& newton) { newton_ = &newton; }
  /// Where the first load step that is not solved is seen to slide without end (StepNewton::Result::slide) and nothing
  /// resists, that is noted in `slide`, unless there is a note; this is taken back when that load step is solved after
  /// all. Must outlive it.
  void setSlide(std::optional<Slide>& slide) { slide_ = &slide; }
  /// Asked on every rank after every iteration.
  void setStop(std::function<bool()> mustStop) { mustStop_ = std::move(mustStop); }
  /// Told on every rank after every load step: step, iterations that it took, fields of the last one.
  void setObserver(std::function<void(int, int, const Iterate&)> observer) { observer_ = std::move(observer); }

  /// Collective. Replaces the columns of `alpha`, one per load step. A step that does not get there in
  /// maximumIterations after its last landing is left as it is. After an early end the remaining columns hold the last
  /// state, or where the guess is the state, what they held.
  End run(base::Matrix& alpha, double tolerance, Guess guess);
  /// Norm of the tractions of the largest load step yet, in the metric of states [force length, square root].
  double largestForce() const { return largestForce_; }
  /// How many load steps, from the first, the last run came to the end of.
  int stepsReached() const { return stepsReached_; }
  /// Whether each of these has come to the tolerance, or to round-off; one that has not was left as it was.
  bool isNearEnough() const { return isNearEnough_; }
  /// What the laws cannot carry, after End::noEquilibrium, or what has not been reached, in words for the user.
  const std::string& reason() const { return reason_; }
  /// In how many parts each load step was solved at most, all runs together; 1: as a whole.
  const std::vector<int>& parts() const;
  /// Of each load step, whether its joint has snapped within it to where it comes to rest, in any run.
  const std::vector<bool>& snaps() const;

 private:
  /// Whether there is Newton's method, and it has not failed too often.
  bool mayTryNewton() const;
  /// Tries it for a state whose iterate is given, then StepNewton::settle(); false where both lead nowhere, with what
  /// that has slid to.
  bool solveByNewton(const Iterate& iterate, base::Matrix& state, double target, std::optional<base::Matrix>& slid);
  /// Looks whether nothing resists at what a load step has slid to.
  void noteSlide(int step, const EquilibriumWatch& watch, const base::Matrix& slid);
  /// What watches over a load step that nothing is known of.
  EquilibriumWatch makeWatch(int step) const;
  /// Whether the residual is what the load step must come to, or forces are lost, see lacksDigits().
  bool isReached(MarchStep& here, double tolerance);
  /// What is lacking for good at a load step, in words for the user.
  std::string describe(int step, Imbalance lack) const;
  /// Ends a load step with that.
  End endWithout(int step, const Imbalance& lack);
  End iterate(int step, base::Matrix& alpha, base::Matrix& state, double tolerance);
  /// |image - state| of what T feels of both, which is kept for accelerate().
  double residual(const base::Matrix& state, const base::Matrix& image);
  /// That of a load step, which remembers the last march where there are not many load steps.
  AndersonAcceleration& accelerationOf(int step);
  /// The next state, of one whose residual() was asked for last.
  void accelerate(AndersonAcceleration& acceleration, base::Matrix& state, const base::Matrix& image);
  /// How exactly T is to be found next.
  substructure::Precision precision();
  /// Size of f^ [force length, square root], at least that of the steps before; with the reactions of eliminated
  /// boundaries when they are asked for, which takes longer.
  double forceSize(const Iterate& iterate, bool withReactions) const;
  /// Goes on with softer search directions: carries all columns of alpha and the state of the present step along.
  void restart(const Iterate& iterate, base::Matrix& alpha, base::Matrix& state);

  FixedPoint& fixedPoint_;
  StepNewton* newton_ = nullptr;
  std::optional<Slide>* slide_ = nullptr;
  int newtonFailures_ = 0;  // in a row, with this search direction
  double accuracy_;
  std::function<bool()> mustStop_;
  std::function<void(int, int, const Iterate&)> observer_;
  std::vector<AndersonAcceleration> accelerations_;  // per load step, or where these are many, one
  base::ColumnStore tractions_;                      // f^ of every load step that was visited
  int restarts_;
  bool leavesWithoutDigits_ = false;
  bool lacksDigits_ = false;
  LoadBalance* balance_ = nullptr;
  std::string reason_;
  double largestForce_ = 0.0;
  int stepsReached_ = 0;
  bool isNearEnough_ = true;
  std::unique_ptr<SofteningSteps> softening_;
  base::Matrix felt_, feltImage_;  // of a state and its image, see UnfeltStates
  /// Error of T over the size of the state that would change nothing, from the last residual and what is gone for; 0:
  /// nothing is known of it.
  double harmless_ = 0.0;
};

}  // namespace harmos::latin
