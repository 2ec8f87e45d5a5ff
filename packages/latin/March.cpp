#include <harmos/latin/March.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/Extrapolation.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/latin/detail/ImageNoise.hpp>
#include <harmos/latin/detail/MarchStep.hpp>
#include <harmos/latin/detail/SafeRelaxation.hpp>
#include <harmos/latin/detail/SofteningSteps.hpp>

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
      softening_(std::make_unique<SofteningSteps>(fixedPoint)) {}

March::~March() = default;

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

std::string March::describe(int step, Imbalance lack) const {
  lack.step = step;
  return describeLack(lack, fixedPoint_.assembly(), balance_ != nullptr && balance_->hasForces(step));
}

void March::noteSlide(int step, const EquilibriumWatch& watch, const base::Matrix& slid) {
  // What follows on a load step that is not solved says nothing.
  if (!isNearEnough_ || fixedPoint_.assembly().path) return;
  const std::optional<Imbalance> lack = watch.lackAt(fixedPoint_, slid);
  if (lack) *slide_ = Slide{step, describe(step, *lack)};
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
  if (static_cast<int>(accelerations_.size()) == fixedPoint_.assembly().steps()) return accelerations_[step];
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

EquilibriumWatch March::makeWatch(int step) const {
  return EquilibriumWatch(
      accuracy_, [this, step](int) { return balance_ != nullptr && balance_->isSure(step); },
      balance_ != nullptr ? balance_->rigidBodies() : std::vector<int>{});
}

bool March::isReached(MarchStep& here, double tolerance) {
  const double enough = tolerance * here.force;
  const bool hasMoved = here.force * manyTimes < here.whole && here.force > nothing * here.whole;
  if (here.residual <= std::max(enough, fixedPoint_.roundOff(here.whole))) {
    // What is reached is the end of the digits, not the tolerance.
    lacksDigits_ = lacksDigits_ || (leavesWithoutDigits_ && hasMoved && here.residual > enough);
    return true;
  }
  const double reach = withinReachOfRoundOff * fixedPoint_.linearStage().softness() * here.whole;
  if (leavesWithoutDigits_ && hasMoved && enough < reach) {
    here.sinceHalved = here.residual < 0.5 * here.halved ? 0 : here.sinceHalved + 1;
    if (here.sinceHalved == 0) here.halved = here.residual;
    if (here.residual <= motionIsKnown * here.whole ||
        (here.sinceHalved >= iterationsToHalve && here.residual <= motionIsGuessed * here.whole)) {
      lacksDigits_ = true;
      return true;
    }
  }
  return false;
}

March::End March::endWithout(int step, const Imbalance& lack) {
  const bool softens = fixedPoint_.assembly().softens();
  reason_ = describe(step, lack);
  if (!softens && !fixedPoint_.assembly().path) return End::noEquilibrium;
  // What was pushed on trial has broken joints that may have held.
  reason_ += std::string("; ") + (softens ? "laws soften" : "loads are to be found") +
             ", so that an equilibrium may have been missed";
  return End::unreached;
}

March::End March::iterate(int step, base::Matrix& alpha, base::Matrix& state, double tolerance) {
  const bool softens = fixedPoint_.assembly().softens();
  AndersonAcceleration& acceleration = accelerationOf(step);
  MarchStep here(makeWatch(step));
  base::Matrix image(state.numRows(), 1);
  if (newton_ != nullptr && softens && fixedPoint_.reference().isEmpty()) {
    // Loads that are found are wild at first, and so is the size of the forces that says what is near enough.
    here.softeningTries = fixedPoint_.assembly().path ? maximumNewtonTries : 1;
  }
  softening_->begin();
  End end = End::reached;
  const Iterate* iterate = nullptr;
  while (here.sinceLanding < maximumIterations && here.landings < maximumLandings) {
    // Where laws soften, small errors choose other ways; and imbalances that last must not be those of single
    // precision.
    const bool mayBeSingle = !softens && here.sinceLanding < iterationsBeforeListening;
    const substructure::Precision used = mayBeSingle ? precision() : substructure::Precision::exact;
    iterate = &fixedPoint_.apply(state, image, used);
    fixedPoint_.settleUnfelt(state, image);
    ++here.iterations;
    ++here.sinceLanding;
    here.residual = residual(state, image);
    here.force = forceSize(*iterate, here.iterations % iterationsPerReaction == 0);
    here.whole = fixedPoint_.metric().norm(image);
    const double enough = tolerance * here.force;
    harmless_ = here.whole > 0.0 ? std::min(negligible * here.residual, enough) / here.whole : 0.0;
    here.isReached = isReached(here, tolerance);
    if (here.isReached) break;
    if (mustStop_ && mustStop_()) {
      end = End::stopped;
      break;
    }
    if (here.floor == 0.0 && (here.wasTried || (softens && here.iterations == iterationsBeforeListening))) {
      // Newton's method has come to what its images say, or to what they cannot say.
      here.floor = noiseOfImages(fixedPoint_, state);
      iterate = &fixedPoint_.apply(state, image);
    }
    here.isReached = here.residual <= here.floor;
    if (here.isReached) break;
    if (here.softeningTries > 0) {
      --here.softeningTries;
      here.wasTried = true;
      const SofteningSteps::Goal goal{newtonShare * enough, forceSize(*iterate, false), largestForce_};
      if (softening_->solve(step, *iterate, alpha, state, goal, *newton_, mustStop_)) {
        acceleration.restart();
        continue;
      }
      here.softeningTries = 0;
      iterate = &fixedPoint_.apply(state, image);
    }
    const bool isStagnant = !fixedPoint_.assembly().isAffine() && here.stagnation.isFound(here.residual, enough);
    if (isStagnant && used == substructure::Precision::single) iterate = &fixedPoint_.apply(state, image);
    if (isStagnant && here.newtonTries < maximumNewtonTries && mayTryNewton()) {
      ++here.newtonTries;
      if (solveByNewton(*iterate, state, newtonShare * enough, here.slid)) {
        acceleration.restart();
        here.lookAgain();
        continue;
      }
      iterate = &fixedPoint_.apply(state, image);
    }
    const bool isTooStiff = isStagnant && restarts_ > 0 && tolerance > leastForRestart * accuracy_;
    const EquilibriumWatch::Finding finding =
        isTooStiff ? EquilibriumWatch::Finding::nothing : here.watch.look(fixedPoint_, iterate, state, image);
    // Where forces exist, softer lines may build the pressures that these do not come to.
    const bool mayBeReached = finding == EquilibriumWatch::Finding::noEquilibrium && restarts_ > 0 &&
                              balance_ != nullptr && balance_->hasForces(step);
    if (isTooStiff || mayBeReached) {
      restart(*iterate, alpha, state);
      here.slid.reset();
      here.lookAgain();
      continue;
    }
    if (finding == EquilibriumWatch::Finding::landing) {
      acceleration.restart();
      ++here.landings;
      here.land();
      continue;
    }
    if (finding == EquilibriumWatch::Finding::noEquilibrium) {
      end = endWithout(step, here.watch.imbalance());
      break;
    }
    if (here.sinceLanding == iterationsBeforeListening) {
      here.isListening = largestImbalance(*iterate).relative > flying;
    }
    if (!here.isListening) {
      accelerate(acceleration, state, image);
      continue;
    }
    for (int row = 0; row < state.numRows(); ++row) state(row, 0) = relaxSafely(state(row, 0), image(row, 0));
  }
  if (here.isReached) largestForce_ = here.force;
  if (end == End::reached && !here.isReached && softens) {
    end = End::unreached;
    reason_ = softening_->describeUnsolved(step);
  }
  if (!here.isReached && here.slid && end != End::noEquilibrium && slide_ != nullptr && !*slide_) {
    noteSlide(step, here.unusedWatch, *here.slid);
    base::Matrix again(image);  // what comes after begins as if nobody had looked
    iterate = &fixedPoint_.apply(state, again);
  }
  isNearEnough_ = isNearEnough_ && here.isReached;
  if (here.isReached && slide_ != nullptr && *slide_ && (*slide_)->step == step) slide_->reset();
  acceleration.pause();
  state.assign(image);
  tractions_.write(step, iterate->hattedTraction()[0]);
  if (observer_) observer_(step, here.iterations, *iterate);
  return end;
}

const std::vector<int>& March::parts() const {
  return softening_->parts();
}

const std::vector<bool>& March::snaps() const {
  return softening_->snaps();
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
