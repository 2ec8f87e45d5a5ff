#include <harmos/latin/March.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/base/Numerals.hpp>
#include <harmos/latin/Extrapolation.hpp>
#include <harmos/latin/StepContinuation.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/ImageNoise.hpp>
#include <harmos/latin/detail/ResultRemarks.hpp>
#include <harmos/latin/detail/SafeRelaxation.hpp>
#include <harmos/latin/detail/Stagnation.hpp>

namespace harmos::latin {
namespace {

constexpr int maximumLandings = 20;
// When so many have not removed a relative imbalance of this size, a body may be flying: the acceleration is left out,
// so that the bodies that it flies among come to rest and the watch sees what is lacking.
constexpr int iterationsBeforeListening = 36;
constexpr double flying = 0.1;
// The size of forces takes the reactions of eliminated boundaries in so often; bodies that are solved on their traces
// must be solved as a whole for them.
constexpr int iterationsPerReaction = 8;
// Of |alpha|, times the softness of the macro problem: round-off in the motion of bodies, so far above the smallest
// number that it hinders no iteration from getting there.
constexpr double withinReachOfRoundOff = 1e-13;
// Forces below this share of |alpha| are nothing but round-off.
constexpr double nothing = 1e-13;
// Where |alpha| is not many times the forces, bodies have not moved much more than they were strained.
constexpr double manyTimes = 10.0;
// Of |alpha|: the motion of bodies is known well enough when the residual has come to this share.
constexpr double motionIsKnown = 1e-7;
// Or when it has not been halved for so many iterations, below the share that follows.
constexpr int iterationsToHalve = 8;
constexpr double motionIsGuessed = 1e-4;
// Newton's method is tried so often at a load step, until it has failed so often in a row, and goes to this share of
// what the step must come to.
constexpr int maximumNewtonTries = 3;
constexpr int maximumNewtonFailures = 3;
constexpr double newtonShare = 0.5;
// Of the residual: errors of single precision that change nothing. Nor may they be above what is gone for, or what the
// acceleration remembers is too rough for the last iterations.
constexpr double negligible = 1e-2;
// Its steps for a whole load step where laws soften; then the load step is divided.
constexpr int mostSofteningSteps = 15;
// Of the accuracy: where a load step stagnates at smaller residuals, that is likelier round-off, of laws or of solves,
// than k. No march goes to just this.
constexpr double leastForRestart = 3e-4;

}  // namespace

March::March(FixedPoint& fixedPoint, int memory, double accuracy, int restarts)
    : fixedPoint_(fixedPoint),
      accuracy_(accuracy),
      accelerations_(fixedPoint.assembly().steps() > stepsAtOnce
                         ? std::size_t{1}
                         : static_cast<std::size_t>(fixedPoint.assembly().steps()),
                     AndersonAcceleration(fixedPoint.metric(), memory, fixedPoint.assembly().isAffine())),
      tractions_(fixedPoint.store(fixedPoint.layout().rows())),
      restarts_(fixedPoint.assembly().isAffine() ? 0 : restarts),
      parts_(static_cast<std::size_t>(fixedPoint.assembly().steps()), 1),
      snaps_(static_cast<std::size_t>(fixedPoint.assembly().steps()), false) {}

double March::forceSize(const Iterate& iterate, bool withReactions) const {
  const double norm = fixedPoint_.metric().norm(iterate.hattedTraction());
  if (!withReactions) return std::max(largestForce_, norm);
  const BoundaryFields& boundaries = iterate.boundaryFields();
  std::vector<double> square(1, 0.0);
  for (int t = 0; t < boundaries.traction.numCols(); ++t) {
    for (std::size_t row = 0; row < boundaries.area.size(); ++row) {
      const double f = boundaries.traction[t][row];
      square[0] += boundaries.area[row] / boundaries.stiffness[row] * f * f;
    }
  }
  fixedPoint_.metric().sum(square);
  return std::max(largestForce_, std::sqrt(norm * norm + square[0]));
}

void March::restart(const Iterate& iterate, base::Matrix& alpha, base::Matrix& state) {
  const std::vector<double> before = fixedPoint_.layout().stiffness();
  base::Matrix traction(state.numRows(), 1);  // a copy: the field goes with the iterate
  traction.assign(iterate.hattedTraction());
  fixedPoint_.rescale(softer * fixedPoint_.searchDirectionScale());
  const std::vector<double>& after = fixedPoint_.layout().stiffness();
  const auto soften = [&](double* to, const double* f) {
    for (std::size_t row = 0; row < after.size(); ++row)
      to[row] = f[row] + after[row] / before[row] * (to[row] - f[row]);
  };
  soften(state[0], traction[0]);
  for (int t = 0; t < alpha.numCols(); ++t) soften(alpha[t], tractions_.read(t));
  for (AndersonAcceleration& acceleration : accelerations_) acceleration.restart();
  // Where softening holds k, forces keep their size, and the larger one is the safer measure.
  if (fixedPoint_.searchDirection().heldBySoftening().empty()) largestForce_ /= std::sqrt(softer);
  newtonFailures_ = 0;
  --restarts_;
}

bool March::mayTryNewton() const {
  return newton_ != nullptr && newtonFailures_ < maximumNewtonFailures;
}

bool March::solveByNewton(const Iterate& iterate, base::Matrix& state, double target,
                          std::optional<base::Matrix>& slid) {
  base::Matrix beta(state.numRows(), 1);  // a copy: the field goes with the next solve
  beta.assign(iterate.beta());
  bool isReached = newton_->solve(state, beta, target, mustStop_).isReached;
  if (!isReached && !fixedPoint_.assembly().softens()) {
    // Its steps may go to and fro between kinks that the way of small iterations goes along.
    StepNewton::Result result = newton_->settle(state, beta, target, mustStop_);
    isReached = result.isReached;
    if (result.slide) slid = std::move(result.slide);
  }
  newtonFailures_ = isReached ? 0 : newtonFailures_ + 1;
  return isReached;
}

void March::noteSlide(int step, const EquilibriumWatch& watch, const base::Matrix& slid) {
  // What follows on a load step that is not solved says nothing.
  if (!isNearEnough_ || fixedPoint_.assembly().path) return;
  std::optional<Imbalance> lack = watch.lackAt(fixedPoint_, slid);
  if (!lack) return;
  lack->step = step;
  *slide_ = Slide{step, describeLack(*lack, fixedPoint_.assembly(), balance_ != nullptr && balance_->hasForces(step))};
}

bool March::solveSoftening(int step, const Iterate& iterate, const base::Matrix& alpha, base::Matrix& state,
                           double target) {
  const int rows = state.numRows();
  base::Matrix beta(rows, 1), whole(rows, 1), before(rows, 1);
  const double share = target / forceSize(iterate, false);
  beta.assign(iterate.beta());  // a copy: the field goes with the next solve
  whole.assign(state);
  const base::Matrix none(rows, 1);
  const auto length = StepNewton::StepLength::damped;
  if (newton_->solveWith(none, whole, beta, target, mostSofteningSteps, length, mustStop_).isReached) {
    state.assign(whole);
    return true;
  }
  const bool isPath = fixedPoint_.assembly().path.has_value();
  const double least = isPath ? share * largestForce_ : target;
  // Parts add round-off to what they have come to already, and end where the joint has snapped.
  const bool isKnown = snaps_[step] || (isPath && parts_[step] > 1);
  if (!isKnown) {
    if (step > 0) std::copy_n(alpha[step - 1], rows, before[0]);
    StepContinuation::Way way{base::Matrix(rows, 1)};
    if (isPath) way.times = growthAlong(fixedPoint_.assembly().path->values, step);
    if (step > 1) std::copy_n(alpha[step - 2], rows, way.from[0]);
    const StepContinuation::Result result =
        StepContinuation(fixedPoint_, *newton_).solve(step, before, way, state, least, share, mustStop_);
    share_ = result.share;
    if (result.isReached) {
      parts_[step] = std::max(parts_[step], result.parts);
      return true;
    }
  }
  fixedPoint_.solveLinear(state, beta);
  if (!newton_->settle(state, beta, least, mustStop_).isReached) return false;
  snaps_[step] = true;
  return true;
}

substructure::Precision March::precision() {
  if (harmless_ == 0.0) return substructure::Precision::exact;
  return fixedPoint_.prepareSingle() <= harmless_ ? substructure::Precision::single : substructure::Precision::exact;
}

double March::residual(const base::Matrix& state, const base::Matrix& image) {
  const UnfeltStates& unfelt = fixedPoint_.linearStage().unfelt();
  if (unfelt.isEmpty()) return fixedPoint_.metric().distance(image, state);
  felt_ = state;
  feltImage_ = image;
  unfelt.remove(felt_);
  unfelt.remove(feltImage_);
  return fixedPoint_.metric().distance(feltImage_, felt_);
}

AndersonAcceleration& March::accelerationOf(int step) {
  if (accelerations_.size() == parts_.size()) return accelerations_[step];
  accelerations_.front().restart();
  return accelerations_.front();
}

void March::accelerate(AndersonAcceleration& acceleration, base::Matrix& state, const base::Matrix& image) {
  if (fixedPoint_.linearStage().unfelt().isEmpty()) {
    acceleration.advance(state, image);
    return;
  }
  acceleration.advance(felt_, feltImage_);
  // What T does not feel is that of the image, so that tractions and displacements can be read from the state.
  for (int row = 0; row < state.numRows(); ++row) state(row, 0) = felt_(row, 0) + image(row, 0) - feltImage_(row, 0);
}

March::End March::iterate(int step, base::Matrix& alpha, base::Matrix& state, double tolerance) {
  const StateMetric& metric = fixedPoint_.metric();
  AndersonAcceleration& acceleration = accelerationOf(step);
  const EquilibriumWatch unused(
      accuracy_, [&](int) { return balance_ != nullptr && balance_->isSure(step); },
      balance_ != nullptr ? balance_->rigidBodies() : std::vector<int>{});
  EquilibriumWatch watch = unused;
  Stagnation stagnation;
  base::Matrix image(state.numRows(), 1);
  int iteration = 0, sinceLanding = 0, landings = 0, sinceHalved = 0, newtonTries = 0;
  double halved = std::numeric_limits<double>::infinity();
  bool isListening = false, isReached = false;
  std::optional<base::Matrix> slid;  // where Newton's method has led with this search direction
  const bool isPath = fixedPoint_.assembly().path.has_value();
  int softeningTries = 0;
  bool wasTried = false;
  double floor = 0.0;  // of residuals, where it was asked for
  if (newton_ != nullptr && fixedPoint_.assembly().softens() && fixedPoint_.reference().isEmpty()) {
    // Loads that are found are wild at first, and so is the size of the forces that says what is near enough.
    softeningTries = isPath ? maximumNewtonTries : 1;
  }
  share_ = 1.0;
  End end = End::reached;
  const Iterate* iterate = nullptr;
  while (sinceLanding < maximumIterations && landings < maximumLandings) {
    // Where laws soften, small errors choose other ways; and imbalances that last must not be those of single
    // precision.
    const bool mayBeSingle = !fixedPoint_.assembly().softens() && sinceLanding < iterationsBeforeListening;
    const substructure::Precision used = mayBeSingle ? precision() : substructure::Precision::exact;
    iterate = &fixedPoint_.apply(state, image, used);
    fixedPoint_.settleUnfelt(state, image);
    ++iteration;
    ++sinceLanding;
    const double size = residual(state, image);
    const double force = forceSize(*iterate, iteration % iterationsPerReaction == 0);
    const double whole = metric.norm(image);
    harmless_ = whole > 0.0 ? std::min(negligible * size, tolerance * force) / whole : 0.0;
    const bool hasMoved = force * manyTimes < whole && force > nothing * whole;
    if (size <= std::max(tolerance * force, fixedPoint_.roundOff(whole))) {
      largestForce_ = force;
      isReached = true;
      // What is reached is the end of the digits, not the tolerance.
      lacksDigits_ = lacksDigits_ || (leavesWithoutDigits_ && hasMoved && size > tolerance * force);
      break;
    }
    if (leavesWithoutDigits_ && hasMoved &&
        tolerance * force < withinReachOfRoundOff * fixedPoint_.linearStage().softness() * whole) {
      sinceHalved = size < 0.5 * halved ? 0 : sinceHalved + 1;
      if (sinceHalved == 0) halved = size;
      if (size <= motionIsKnown * whole || (sinceHalved >= iterationsToHalve && size <= motionIsGuessed * whole)) {
        largestForce_ = force;
        lacksDigits_ = true;
        isReached = true;
        break;
      }
    }
    if (mustStop_ && mustStop_()) {
      end = End::stopped;
      break;
    }
    if (floor == 0.0 && (wasTried || (fixedPoint_.assembly().softens() && iteration == iterationsBeforeListening))) {
      // Newton's method has come to what its images say, or to what they cannot say.
      floor = noiseOfImages(fixedPoint_, state);
      iterate = &fixedPoint_.apply(state, image);
    }
    if (size <= floor) {
      largestForce_ = force;
      isReached = true;
      break;
    }
    if (softeningTries > 0) {
      --softeningTries;
      wasTried = true;
      if (solveSoftening(step, *iterate, alpha, state, newtonShare * tolerance * force)) {
        acceleration.restart();
        continue;
      }
      softeningTries = 0;
      iterate = &fixedPoint_.apply(state, image);
    }
    const bool isStagnant = !fixedPoint_.assembly().isAffine() && stagnation.isFound(size, tolerance * force);
    if (isStagnant && used == substructure::Precision::single) iterate = &fixedPoint_.apply(state, image);
    if (isStagnant && newtonTries < maximumNewtonTries && mayTryNewton()) {
      ++newtonTries;
      if (solveByNewton(*iterate, state, newtonShare * tolerance * force, slid)) {
        acceleration.restart();
        watch = unused;
        stagnation = Stagnation();
        sinceLanding = 0;
        isListening = false;
        continue;
      }
      iterate = &fixedPoint_.apply(state, image);
    }
    const bool isTooStiff = isStagnant && restarts_ > 0 && tolerance > leastForRestart * accuracy_;
    const EquilibriumWatch::Finding finding =
        isTooStiff ? EquilibriumWatch::Finding::nothing : watch.look(fixedPoint_, iterate, state, image);
    // Where forces exist, softer lines may build the pressures that these do not come to.
    const bool mayBeReached = finding == EquilibriumWatch::Finding::noEquilibrium && restarts_ > 0 &&
                              balance_ != nullptr && balance_->hasForces(step);
    if (isTooStiff || mayBeReached) {
      restart(*iterate, alpha, state);
      slid.reset();
      watch = unused;
      stagnation = Stagnation();
      sinceLanding = 0;
      isListening = false;
      continue;
    }
    if (finding == EquilibriumWatch::Finding::landing) {
      acceleration.restart();
      stagnation = Stagnation();
      sinceLanding = 0;
      ++landings;
      isListening = false;
      continue;
    }
    if (finding == EquilibriumWatch::Finding::noEquilibrium) {
      Imbalance imbalance = watch.imbalance();
      imbalance.step = step;
      reason_ = describeLack(imbalance, fixedPoint_.assembly(), balance_ != nullptr && balance_->hasForces(step));
      end = End::noEquilibrium;
      if (fixedPoint_.assembly().softens() || isPath) {
        // What was pushed on trial has broken joints that may have held.
        reason_ += std::string("; ") + (fixedPoint_.assembly().softens() ? "laws soften" : "loads are to be found") +
                   ", so that an equilibrium may have been missed";
        end = End::unreached;
      }
      break;
    }
    if (sinceLanding == iterationsBeforeListening) isListening = largestImbalance(*iterate).relative > flying;
    if (!isListening) {
      accelerate(acceleration, state, image);
      continue;
    }
    for (int row = 0; row < state.numRows(); ++row) state(row, 0) = relaxSafely(state(row, 0), image(row, 0));
  }
  if (end == End::reached && !isReached && fixedPoint_.assembly().softens()) {
    end = End::unreached;
    reason_ = "load step " + std::to_string(step + 1) + ", time " + base::toText(fixedPoint_.assembly().times[step]) +
              ", has no solution near that of the load step before" +
              (share_ < 1.0 ? ": it could be followed through " + base::toText(std::round(1e3 * share_) / 10.0) +
                                  " % of the load step, where the joint snaps"
                            : "") +
              "; the laws of " + namesOfSoftening(fixedPoint_.assembly()) + " soften";
    if (!isPath) {
      reason_ +=
          ": let the size of the loads be found (Path Following), or refine the mesh along "
          "the joint or lower its strength, as a crack needs that jumps from point to point";
    } else {
      reason_ +=
          ": control what the loads open most, such as the mouth of a crack, go on in smaller load steps, or let "
          "the Scale of the Search Direction be 0.1 or 0.01, as slender parts need it";
    }
  }
  if (!isReached && slid && end != End::noEquilibrium && slide_ != nullptr && !*slide_) {
    noteSlide(step, unused, *slid);
    base::Matrix again(image);  // what comes after begins as if nobody had looked
    iterate = &fixedPoint_.apply(state, again);
  }
  isNearEnough_ = isNearEnough_ && isReached;
  if (isReached && slide_ != nullptr && *slide_ && (*slide_)->step == step) slide_->reset();
  acceleration.pause();
  state.assign(image);
  tractions_.write(step, iterate->hattedTraction()[0]);
  if (observer_) observer_(step, iteration, *iterate);
  return end;
}

March::End March::run(base::Matrix& alpha, double tolerance, Guess guess) {
  const int rows = alpha.numRows();
  base::Matrix state(rows, 1);  // no view of alpha: copies of a view share its values
  End end = End::reached;
  // All load steps are selected again at the end, also when a law throws.
  const FixedPoint::AllStepsAtEnd restore(fixedPoint_);
  fixedPoint_.startUnloaded();
  stepsReached_ = 0;
  isNearEnough_ = true;
  lacksDigits_ = false;
  harmless_ = 0.0;
  for (int t = 0; t < alpha.numCols(); ++t) {
    // What an earlier run has found for the steps to come is better than a copy.
    if (end != End::reached && guess == Guess::state) break;
    if (end == End::reached && balance_ != nullptr && balance_->contradiction(t)) {
      reason_ = *balance_->contradiction(t);
      end = End::noEquilibrium;
    }
    if (end == End::reached) {
      switch (guess) {
        case Guess::extrapolation:
          if (fixedPoint_.assembly().path) {
            extrapolateAlong(alpha, t, fixedPoint_.assembly().path->values, state[0]);
          } else {
            extrapolate(alpha, t, fixedPoint_.assembly().times, state[0]);
          }
          break;
        case Guess::nothing:
          state.putScalar(0.0);
          break;
        case Guess::state:
          std::copy_n(alpha[t], rows, state[0]);
      }
      fixedPoint_.select({t});
      end = iterate(t, alpha, state, tolerance);
      fixedPoint_.startFromHere();
      if (end == End::reached) ++stepsReached_;
    }
    std::copy_n(state[0], rows, alpha[t]);
  }
  return end;
}

}  // namespace harmos::latin
