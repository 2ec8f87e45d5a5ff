#include <harmos/latin/detail/SimultaneousIteration.hpp>

#include <algorithm>
#include <optional>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/EquilibriumWatch.hpp>
#include <harmos/latin/detail/CustomaryIndicator.hpp>
#include <harmos/latin/detail/IterationWatch.hpp>

namespace harmos::latin {
namespace {

// A correction gains about a factor of ten, so a certificate is worth its price from here on.
constexpr double triggerFactor = 15.0;
// Of the trigger, after a certificate that failed.
constexpr double triggerAfterFailure = 0.3;
// Most linear stages from a certificate that failed to the next.
constexpr int longestWait = 15;

}  // namespace

void SimultaneousIteration::run(base::Matrix& alpha, base::Matrix& image, int stagesBefore, const Callbacks& callbacks,
                                LatinResult& result) {
  const auto stages = [&] { return fixedPoint_.linearStage().stages() - stagesBefore; };
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::optional<AndersonAcceleration> acceleration;
  if (options_.algorithm == Algorithm::accelerated) {
    acceleration.emplace(fixedPoint_.metric(), options_.memory, assembly.isAffine());
  }
  for (int t = 0; t < assembly.steps(); ++t) {
    if (!balance_.contradiction(t)) continue;
    result.outcome = Outcome::noEquilibrium;
    result.reason = *balance_.contradiction(t);
    return;
  }
  EquilibriumWatch watch(
      options_.accuracy, [&](int step) { return balance_.isSure(step); }, balance_.rigidBodies());
  IterationWatch progress(fixedPoint_, responses_);
  double trigger = triggerFactor * options_.accuracy;
  int nextAttempt = 0;  // linear stages before which a failed certificate is not tried again
  while (stages() < options_.maximumIterations) {
    const Iterate* iterate = &fixedPoint_.apply(alpha, image);
    ++result.iterations;
    if (progress.hasDiverged(image)) {
      // Kinks of the laws can mislead the acceleration that far: without it, from the start.
      acceleration.reset();
      alpha.putScalar(0.0);
      progress.forget();
      continue;
    }
    double change = 0.0;
    const bool quiet = progress.isSettled(result.iterations, *iterate, trigger, change);
    if (callbacks.observe) {
      callbacks.observe(*iterate, {result.iterations, stages(), customaryIndicator(*iterate), change, -1});
    }
    if (callbacks.mustStop()) {
      result.outcome = Outcome::interrupted;
      result.reason = "interrupted";
      return;
    }
    const EquilibriumWatch::Finding finding = watch.look(fixedPoint_, iterate, alpha, image);
    if (finding == EquilibriumWatch::Finding::landing) {
      if (acceleration) acceleration->restart();
      progress.forget();
      continue;
    }
    if (finding == EquilibriumWatch::Finding::noEquilibrium) {
      result.outcome = Outcome::noEquilibrium;
      result.reason = describeLack(watch.imbalance(), assembly, balance_.hasForces(watch.imbalance().step));
      return;
    }
    if (quiet && stages() >= nextAttempt) {
      const int before = stages();
      if (callbacks.certify(*iterate)) return;
      // What was spent on an estimate that failed is spent on iterations before the next one.
      nextAttempt = stages() + std::min(stages() - before, longestWait);
      trigger *= triggerAfterFailure;
      if (acceleration) acceleration->restart();
      progress.forget();
      continue;
    }
    const auto running = timers_.start("acceleration");
    if (acceleration) {
      acceleration->advance(alpha, image);
      continue;
    }
    const double relaxation = options_.algorithm == Algorithm::plain ? 1.0 : options_.relaxation;
    for (int t = 0; t < alpha.numCols(); ++t) {
      for (int row = 0; row < alpha.numRows(); ++row) alpha[t][row] += relaxation * (image[t][row] - alpha[t][row]);
    }
  }
}

}  // namespace harmos::latin
