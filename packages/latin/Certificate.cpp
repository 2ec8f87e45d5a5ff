#include <harmos/latin/Certificate.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/EquilibriumCheck.hpp>
#include <harmos/latin/March.hpp>
#include <harmos/latin/StepwiseCorrection.hpp>
#include <harmos/latin/detail/ErrorEstimate.hpp>
#include <harmos/latin/detail/ImageNoise.hpp>
#include <harmos/latin/detail/LargestOf.hpp>
#include <harmos/latin/detail/SafeRelaxation.hpp>
#include <harmos/latin/detail/UnheldParts.hpp>

namespace harmos::latin {
namespace {

// Of the largest residual of a load step, of the first correction and of later ones; what must have been reached is
// twice that.
constexpr double firstTarget = 0.1;
constexpr double laterTarget = ErrorEstimate::usualShare;
constexpr double causalLimit = 2.0;
// Of the largest residual of a load step: what those of others count as, at least, in a stepwise correction.
constexpr double leastResidual = 0.3;
// Of the accuracy: error that the first correction goes for, so that the second one can show that it is small enough.
constexpr double shareOfAccuracy = 0.33;
constexpr int maximumStages = 40;
constexpr int leastStages = 1;  // that must be affordable, with those that follow
// Times that a stepwise correction goes on to a tenth of the residual when too much can be hidden in it.
constexpr int maximumPasses = 3;
constexpr double nextPass = 0.1;
constexpr double allowedToHide = 0.5;
// Residual over the accuracy of the forces up to which, unless laws soften, it is worth asking whether it is round-off;
// a larger one is brought down with a march to a smaller tolerance.
constexpr double mayBeNoise = 0.01;

// Of Newton corrections.
constexpr int leastVectors = 40;
constexpr int maximumVectors = 150;
constexpr double krylovTarget = 0.1;
constexpr double krylovLimit = 0.15;
// Of corrections that start close to the fixed point: what is left is in modes that hardly show in the residual.
constexpr double closeTarget = 0.02;
constexpr int smoothingIterations = 4;

constexpr int maximumCorrections = 8;

// Of the largest sum of forces on a body: where there are less, no balance is expected of them.
constexpr double shareOfForces = 1e-3;
// A state so many times larger than the image of nothing, in which bodies are beyond reach, was not asked for.
constexpr double thrownSize = 1e4;

/// Whether what is far away is where it belongs: springs, however soft, or contacts hold all parts, and their forces
/// balance the loads to `accuracy` without anything added for the digits that k w takes from them.
bool isHeldThere(const Iterate& iterate, double accuracy) {
  return largestImbalance(iterate, {}, shareOfForces).relative <= accuracy &&
         UnheldParts(iterate, nullptr, {}).remarks().empty();
}

/// An iterate has thrown a body so far away that forces are lost beside k w and everything is small beside its way. The
/// image of nothing tells ways that are prescribed. `iterate` and `image` are those of alpha, also afterwards.
bool isThrown(FixedPoint& fixedPoint, const Iterate*& iterate, const base::Matrix& alpha, base::Matrix& image,
              double accuracy) {
  if (!NaturalSizes(*iterate).isBeyondReach() || isHeldThere(*iterate, accuracy)) return false;
  const base::Matrix nothing(alpha.numRows(), alpha.numCols());
  fixedPoint.apply(nothing, image);
  const double size = fixedPoint.metric().norm(image);
  iterate = &fixedPoint.apply(alpha, image);
  return fixedPoint.metric().norm(alpha) > thrownSize * size;
}

/// Norm of the forces of the load step with the largest ones.
double forcesOf(const Iterate& iterate) {
  return std::sqrt(largest(iterate.metric().squaredNorms(iterate.hattedTraction())));
}

/// Error of the forces [-] that residuals which count as round-off of a state with this gap, much larger than its
/// forces where bodies have moved far, may still stand for.
double leftToRoundOff(const FixedPoint& fixedPoint, const base::Matrix& alpha, const Iterate& iterate, double gap) {
  const double whole = std::sqrt(largest(fixedPoint.metric().squaredNorms(alpha)));
  const double forces = forcesOf(iterate);
  const double unseen = forces > 0.0 ? std::min(gap, fixedPoint.roundOff(whole) / forces) : gap;
  return errorOfRoundOff * unseen;
}

/// Round-off in images of the largest load step of a state, all of which are selected.
double noiseOfLargest(FixedPoint& fixedPoint, const base::Matrix& alpha) {
  const std::vector<double> squares = fixedPoint.metric().squaredNorms(alpha);
  const int step = static_cast<int>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  base::Matrix state(alpha.numRows(), 1);
  std::copy_n(alpha[step], alpha.numRows(), state[0]);
  const FixedPoint::AllStepsAtEnd restore(fixedPoint);
  fixedPoint.select({step});
  return noiseOfImages(fixedPoint, state);
}

}  // namespace

double fieldGap(const Iterate& state) {
  const std::vector<double>& area = state.layout().area();
  std::vector<double> sums(4, 0.0);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    const double* f = state.traction()[t];
    const double* hattedF = state.hattedTraction()[t];
    const double* w = state.trace()[t];
    const double* relativeW = state.relativeTrace()[t];
    for (std::size_t row = 0; row < area.size(); ++row) {
      const double between = relativeW[row] - state.relativeHattedTrace(static_cast<int>(row), t);
      sums[0] += area[row] * (f[row] - hattedF[row]) * (f[row] - hattedF[row]);
      sums[1] += area[row] * hattedF[row] * hattedF[row];
      sums[2] += area[row] * between * between;
      sums[3] += area[row] * w[row] * w[row];
    }
  }
  const BoundaryFields& boundaries = state.boundaryFields();
  for (int t = 0; t < boundaries.traction.numCols(); ++t) {
    for (std::size_t row = 0; row < boundaries.area.size(); ++row) {
      const double f = boundaries.traction[t][row], w = boundaries.trace[t][row];
      sums[1] += boundaries.area[row] * f * f;
      sums[3] += boundaries.area[row] * w * w;
    }
  }
  state.metric().sum(sums);
  const NaturalSizes sizes(state);
  const double force = sums[0] == 0.0 ? 0.0 : std::sqrt(sums[0] / std::max(sums[1], sizes.squaredForceFloor()));
  const double displacement =
      sums[2] == 0.0 ? 0.0 : std::sqrt(sums[2] / std::max(sums[3], sizes.squaredDisplacementFloor()));
  return std::max(force, displacement);
}

Certificate::Certificate(FixedPoint& fixedPoint, StepNewton& newton,
                         const std::vector<std::shared_ptr<const Response>>& responses, double accuracy)
    : fixedPoint_(fixedPoint), responses_(responses), accuracy_(accuracy), stepNewton_(newton), newton_(fixedPoint) {
  if (fixedPoint.formulation() == Formulation::displacement) {
    causal_ = std::make_unique<CausalCorrection>(fixedPoint, substructure::Precision::single);
  }
}

Certificate::~Certificate() = default;

Certificate::Correction Certificate::correctCausally(const Iterate& iterate, base::Matrix& state, base::Matrix& image,
                                                     int count, int stages) {
  Correction result;
  CausalCorrection::Goal goal;
  if (count == 0) {
    goal = {firstTarget, shareOfAccuracy * accuracy_};
  } else {
    goal = {laterTarget};
    goal.isLater = true;
  }
  const CausalCorrection::Result step = causal_->correct(iterate, state, image, goal, std::min(stages, maximumStages));
  result.reduction = step.reduction;
  result.shares = step.shares;
  result.isReduced = step.reduction <= causalLimit * goal.reduction;
  result.hidden = step.hidden;
  result.iterate = step.iterate;
  return result;
}

Certificate::Correction Certificate::correctStepwise(const Iterate& iterate, base::Matrix& state, base::Matrix& image,
                                                     int count, int stageLimit) {
  const StateMetric& metric = fixedPoint_.metric();
  const auto distances = [&](const base::Matrix& a, const base::Matrix& b) {
    base::Matrix difference(a);
    difference -= b;
    fixedPoint_.linearStage().unfelt().remove(difference);
    std::vector<double> norms = metric.squaredNorms(difference);
    for (double& norm : norms) norm = std::sqrt(norm);
    return norms;
  };
  Correction result;
  const base::Matrix start(state);
  double noise = fixedPoint_.roundOff(std::sqrt(largest(metric.squaredNorms(state))));
  bool knowsNoise = false;
  // Every load step must be moved, or what is wrong with one would go unseen beside larger residuals of others.
  std::vector<double> targets = distances(image, state);
  const double before = largest(targets);
  if (before <= noise_) {  // what an attempt has found once is all that there is
    result.reduction = 0.0;
    result.isReduced = result.isRoundOff = true;
    result.iterate = &iterate;
    return result;
  }
  const double share = count == 0 ? firstTarget : laterTarget;
  double target = share * before;
  for (double& own : targets) own = share * std::max(own, leastResidual * before);
  StepwiseCorrection correction(fixedPoint_, stepNewton_);
  const Iterate* present = &iterate;
  const bool isSoft = fixedPoint_.assembly().softens();
  base::Matrix kept(state.numRows(), state.numCols());  // of the pass before
  double reached = 0.0;                                 // its residual
  for (int pass = 0; pass < maximumPasses; ++pass) {
    if (pass > 0) {
      target *= nextPass;
      for (double& own : targets) own *= nextPass;
    }
    const StepwiseCorrection::Result step = correction.correct(*present, state, target, targets, stageLimit);
    if (!step.isReached && (pass == 0 || !isSoft)) return result;
    double left = 0.0;
    if (step.isReached) {
      present = &fixedPoint_.apply(state, image);
      result.iterate = present;
      left = largest(distances(image, state));
    }
    // Images promise residuals that their own round-off does not allow: then the pass before has met it already, and
    // directions out of round-off would pass for soft modes.
    if (!step.isReached || (isSoft && pass > 0 && left >= reached)) {
      state.assign(kept);
      result.iterate = &fixedPoint_.apply(state, image);
      break;
    }
    const bool isMissed = left > std::max(causalLimit * target, noise);
    if (!knowsNoise && isMissed && (isSoft || left <= mayBeNoise * accuracy_ * forcesOf(*present))) {
      noise = std::max(noise, noiseOfLargest(fixedPoint_, state));
      knowsNoise = true;
      if (!isSoft) noise_ = noise;
      present = &fixedPoint_.apply(state, image);
      result.iterate = present;
    }
    reached = left;
    result.reduction = left <= noise ? 0.0 : left / before;
    const double seen = step.smallestSingularValue * largest(distances(state, start));
    result.hidden = left <= noise ? 0.0 : left / seen;
    result.isRoundOff = knowsNoise && left <= noise;
    if (result.hidden <= allowedToHide) break;
    kept.assign(state);
  }
  result.isReduced = result.reduction <= causalLimit * share;
  return result;
}

Certificate::Correction Certificate::correctByNewton(const Iterate& iterate, base::Matrix& state,
                                                     const base::Matrix& image, bool isClose, int stages) {
  Correction result;
  const NewtonCorrection::Result step =
      newton_.solve(iterate, state, image, isClose ? closeTarget : krylovTarget, std::min(stages, maximumVectors));
  result.reduction = step.reduction;
  result.isReduced = step.reduction <= krylovLimit;
  result.hidden = step.hidden;
  if (result.isReduced) state += step.step;
  return result;
}

const Iterate& Certificate::smooth(base::Matrix& state, base::Matrix& image) {
  const Iterate* iterate = nullptr;
  for (int i = 0; i < smoothingIterations; ++i) {
    for (int t = 0; t < state.numCols(); ++t) {
      for (int row = 0; row < state.numRows(); ++row) state[t][row] = relaxSafely(state[t][row], image[t][row]);
    }
    iterate = &fixedPoint_.apply(state, image);
  }
  return *iterate;
}

Snapshot Certificate::lookAtShared(const Iterate& iterate, base::Matrix& state, base::Matrix& image) {
  const base::Matrix shared = fixedPoint_.shareTractions(state, image, accuracy_);
  Snapshot snapshot(iterate, responses_);
  fixedPoint_.takeBack(shared, state, image);
  return snapshot;
}

Certificate::Result Certificate::attempt(const Iterate& first, base::Matrix& alpha, base::Matrix& image,
                                         int stageLimit) {
  if (!causal_) return attemptOnce(Kind::newton, first, alpha, image, stageLimit);
  if (stepNewton_.isUsed()) return attemptOnce(Kind::stepwise, first, alpha, image, stageLimit);
  Result result = attemptOnce(Kind::causal, first, alpha, image, stageLimit);
  if (!result.stagnated) return result;
  // The iteration may come nearer for much less than it costs to correct load steps one by one.
  const bool isFirst = !std::exchange(hasStagnated_, true);
  if (isFirst && !fixedPoint_.assembly().softens()) return result;
  return attemptOnce(Kind::stepwise, fixedPoint_.apply(alpha, image), alpha, image, stageLimit);
}

Certificate::Result Certificate::attemptOnce(Kind kind, const Iterate& first, base::Matrix& state, base::Matrix& image,
                                             int stageLimit) {
  Result result;
  const bool isNewton = kind == Kind::newton;
  const Iterate* iterate = &first;
  auto before = std::make_unique<Snapshot>(lookAtShared(*iterate, state, image));
  noise_ = 0.0;
  ErrorEstimate estimate(accuracy_, isNewton ? ErrorEstimate::Delivered::a1 : ErrorEstimate::Delivered::a2);
  for (int count = 0; count < maximumCorrections; ++count) {
    const double gapBefore = isNewton ? fieldGap(*iterate) : 0.0;
    const base::Matrix smoothed(isNewton ? state : base::Matrix());
    const int stages = stageLimit - fixedPoint_.linearStage().stages() - smoothingIterations - 2;
    if (stages < (isNewton ? leastVectors : leastStages)) return result;
    Correction step = kind == Kind::causal     ? correctCausally(*iterate, state, image, count, stages)
                      : kind == Kind::stepwise ? correctStepwise(*iterate, state, image, count, stageLimit - 2)
                                               : correctByNewton(*iterate, state, image, estimate.isSettled(), stages);
    if (!step.isReduced) {
      result.conclusive = false;
      result.stagnated = true;
      return result;
    }
    step.shares.resize(static_cast<std::size_t>(state.numCols()), step.reduction);
    result.isRoundOff = step.isRoundOff;
    iterate = step.iterate != nullptr ? step.iterate : &fixedPoint_.apply(state, image);
    auto after = std::make_unique<Snapshot>(lookAtShared(*iterate, state, image));
    estimate.add(*before, *after, step.reduction, step.shares, step.hidden);
    if (estimate.isKnown()) {
      result.contraction = estimate.contraction();
      result.conclusive = !estimate.grows();
      const double gap = fieldGap(*iterate);
      estimate.addUnseen(leftToRoundOff(fixedPoint_, state, *iterate, gap));
      if (result.conclusive) result.estimates = estimate.errors();
      result.claimed = estimate.isSmall() && (isNewton ? gapBefore : gap) <= allowedGap * accuracy_ &&
                       !isThrown(fixedPoint_, iterate, state, image, accuracy_);
      if (isNewton && (result.claimed || estimate.grows())) {
        state.assign(smoothed);
        return result;
      }
      if (result.claimed) {
        result.iterate = iterate;
        return result;
      }
    }
    if (isNewton) {
      iterate = &smooth(state, image);
      before = std::make_unique<Snapshot>(lookAtShared(*iterate, state, image));
    } else {
      before = std::move(after);
    }
    result.conclusive = false;
  }
  return result;
}

}  // namespace harmos::latin
