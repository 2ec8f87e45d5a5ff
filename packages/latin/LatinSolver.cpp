#include <harmos/latin/LatinSolver.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/FreeMotion.hpp>
#include <harmos/latin/Starts.hpp>
#include <harmos/mesh/Vector.hpp>

namespace harmos::latin {
namespace {

// Promised quantities are compared with those of four iterations before; looking every second time is enough.
constexpr int lookEvery = 2;
constexpr std::size_t lookBack = 2;
// A correction gains about a factor of ten, so a certificate is worth its price from here on.
constexpr double triggerFactor = 15.0;

// After a good start little changes at first; the gap tells that this is not yet the end.
constexpr double gapFactor = 0.02;
// A load that is not carried shows as so many imbalances in a row, each this many iterations apart (odd, so that an
// iteration that jumps to and fro is not taken for it), that agree to within 5 %.
constexpr int imbalanceEvery = 9;
constexpr std::ptrdiff_t imbalanceCount = 4;
constexpr double imbalanceSpread = 0.05;
// A path that the iteration over all load steps has not found by then is followed step after step.
constexpr int patience = 40;
// Of the accuracy asked for: the residual at which a march goes on to the next load step.
constexpr double marchShare = 0.3;

// A state this many times larger than the first one was extrapolated beyond all measure: the digits of the forces are
// lost in k w, and everything finite would look small beside it.
constexpr double divergedSize = 1e8;

/// True when two vectors agree to within imbalanceSpread.
bool agree(const mesh::Point& a, const mesh::Point& b) {
  return mesh::distance(a, b) <= imbalanceSpread * mesh::norm(b);
}

/// True when one body has lacked the same reaction for a while, although everything else may have settled.
bool persists(const std::vector<Imbalance>& history, double accuracy) {
  if (static_cast<std::ptrdiff_t>(history.size()) < imbalanceCount) return false;
  const Imbalance& last = history.back();
  return std::all_of(history.end() - imbalanceCount, history.end(), [&](const Imbalance& one) {
    return one.body == last.body && one.step == last.step && one.relative >= accuracy &&
           (agree(one.force, last.force) || agree(one.moment, last.moment));
  });
}

/// The customary indicator |s - s^| / |s| with s = (f, w) in the norm that k makes.
double customaryIndicator(const FixedPoint& state) {
  const std::vector<double>& area = state.layout().area();
  const std::vector<double>& k = state.layout().stiffness();
  std::vector<double> sums(2, 0.0);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    for (std::size_t row = 0; row < area.size(); ++row) {
      const double f = state.traction()[t][row];
      const double w = state.trace()[t][row];
      const double df = f - state.hattedTraction()[t][row];
      const double dw = w - state.hattedTrace()[t][row];
      sums[0] += area[row] * (df * df / k[row] + k[row] * dw * dw);
      sums[1] += area[row] * (f * f / k[row] + k[row] * w * w);
    }
  }
  state.metric().sum(sums);
  return sums[1] > 0.0 ? std::sqrt(sums[0] / sums[1]) : 0.0;
}

}  // namespace

LatinSolver::LatinSolver(const interface::Assembly& assembly, const LatinOptions& options,
                         Teuchos::RCP<const Teuchos::Comm<int>> comm, base::Timers& timers)
    : assembly_(assembly), options_(options), timers_(timers), fixedPoint_(assembly, options.stages, comm, timers) {}

bool LatinSolver::mustStop() const {
  const int here = interrupted_ && interrupted_() ? 1 : 0;
  int anywhere = 0;
  Teuchos::reduceAll(fixedPoint_.layout().comm(), Teuchos::REDUCE_MAX, here, Teuchos::outArg(anywhere));
  return anywhere != 0;
}

bool LatinSolver::settled(int iteration, double tolerance, double& change) {
  if (iteration % lookEvery != 0) return false;
  snapshots_.push_back(std::make_unique<Snapshot>(fixedPoint_, responses_));
  if (snapshots_.size() <= lookBack) return false;
  const std::vector<double> changes = snapshots_.back()->distance(*snapshots_[snapshots_.size() - 1 - lookBack]);
  change = *std::max_element(changes.begin(), changes.end());
  snapshots_.erase(snapshots_.begin());
  return change <= tolerance && fieldGap(fixedPoint_) <= gapFactor * tolerance;
}

bool LatinSolver::hasDiverged(const base::Matrix& state) {
  const double size = fixedPoint_.metric().norm(state);
  if (startSize_ == 0.0) startSize_ = size;
  return !(size <= divergedSize * startSize_);
}

bool LatinSolver::dependsOnPath() const {
  if (assembly_.steps() == 1 || fixedPoint_.formulation() != Formulation::displacement) return false;
  return std::any_of(assembly_.interfaces.begin(), assembly_.interfaces.end(),
                     [](const interface::Interface& one) { return one.law->historySize() > 0; });
}

LatinResult LatinSolver::solve(const base::Matrix* start) {
  const int rows = fixedPoint_.layout().rows();
  const int stagesBefore = fixedPoint_.linearStage().stages();
  alpha_.shape(rows, assembly_.steps());
  image_.shape(rows, assembly_.steps());
  startSize_ = 0.0;
  if (start != nullptr) {
    alpha_.assign(*start);
  } else if (options_.algorithm == Algorithm::accelerated) {
    const auto running = timers_.start("acceleration");
    startFromCoarseSteps(fixedPoint_, alpha_, options_.memory);
  }
  snapshots_.clear();

  LatinResult result;
  std::optional<AndersonAcceleration> acceleration;
  if (options_.algorithm == Algorithm::accelerated) acceleration.emplace(fixedPoint_.metric(), options_.memory);
  double trigger = triggerFactor * options_.accuracy;
  int nextAttempt = 0;  // linear stages before which a failed certificate is not tried again
  std::vector<double> estimates;
  std::vector<Imbalance> imbalances;

  const auto stages = [&] { return fixedPoint_.linearStage().stages() - stagesBefore; };
  while (stages() < options_.maximumIterations) {
    fixedPoint_.apply(alpha_, image_);
    ++result.iterations;
    if (hasDiverged(image_)) {
      // Kinks of the laws can mislead the acceleration that far: without it, from the start.
      acceleration.reset();
      alpha_.putScalar(0.0);
      snapshots_.clear();
      continue;
    }
    double change = 0.0;
    const bool quiet = settled(result.iterations, trigger, change);
    if (!observers_.empty()) {
      const IterationReport report{result.iterations, stages(), customaryIndicator(fixedPoint_), change};
      for (const auto& observer : observers_) observer(report);
    }
    if (mustStop()) {
      result.outcome = Outcome::interrupted;
      result.reason = "interrupted";
      break;
    }
    if (result.iterations % imbalanceEvery == 0) {
      imbalances.push_back(largestImbalance(fixedPoint_));
      if (persists(imbalances, options_.accuracy) && movesFreely(imbalances.back(), fixedPoint_, alpha_, image_)) {
        result.outcome = Outcome::noEquilibrium;
        result.reason = "the interface laws cannot carry the loads; " + describe(imbalances.back(), assembly_);
        break;
      }
    }
    if (quiet && stages() >= nextAttempt) {
      const int begin = stages();
      const auto running = timers_.start("certificate");
      Certificate certificate(fixedPoint_, responses_, options_.accuracy);
      Certificate::Result attempt = certificate.attempt(alpha_, image_, stagesBefore + options_.maximumIterations);
      if (attempt.conclusive) estimates = attempt.estimates;
      alpha_.assign(attempt.state);
      if (attempt.claimed) {
        result.outcome = Outcome::certified;
        result.reason = "the error estimate is below the accuracy asked for";
        break;
      }
      // What was spent on an estimate that failed is spent on iterations before the next one.
      nextAttempt = stages() + std::min(stages() - begin, 15);
      trigger *= 0.3;
      if (acceleration) acceleration->restart();
      snapshots_.clear();
      continue;
    }
    const auto running = timers_.start("acceleration");
    if (acceleration && result.iterations == patience && dependsOnPath()) {
      marchThroughSteps(fixedPoint_, alpha_, options_.memory, marchShare * options_.accuracy,
                        [&] { return mustStop() || stages() >= options_.maximumIterations; });
      acceleration->restart();
      snapshots_.clear();
    } else if (acceleration) {
      acceleration->advance(alpha_, image_);
    } else {
      const double relaxation = options_.algorithm == Algorithm::plain ? 1.0 : options_.relaxation;
      for (int t = 0; t < alpha_.numCols(); ++t) {
        for (int row = 0; row < rows; ++row) alpha_[t][row] += relaxation * (image_[t][row] - alpha_[t][row]);
      }
    }
  }
  deliver(result, estimates);
  result.linearStages = stages();
  return result;
}

void LatinSolver::deliver(LatinResult& result, const std::vector<double>& estimates) {
  fixedPoint_.apply(alpha_, image_);
  result.indicator = customaryIndicator(fixedPoint_);
  const Snapshot last(fixedPoint_, responses_);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < responses_.size(); ++i) {
    result.responses.push_back(
        {responses_[i]->name(), last.responses()[i], estimates.empty() ? unknown : estimates[i]});
  }
  result.forceErrorEstimate = estimates.empty() ? unknown : estimates[estimates.size() - 2];
  result.displacementErrorEstimate = estimates.empty() ? unknown : estimates.back();
  result.errorEstimate = estimates.empty() ? unknown : *std::max_element(estimates.begin(), estimates.end());
  if (result.outcome != Outcome::iterationLimit) return;
  const Imbalance imbalance = largestImbalance(fixedPoint_);
  result.reason = "iteration limit of " + std::to_string(options_.maximumIterations) + " linear stages; worst " +
                  (imbalance.body < 0 ? "imbalance: none" : describe(imbalance, assembly_));
}

}  // namespace harmos::latin
