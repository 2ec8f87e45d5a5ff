#include <harmos/latin/Certificate.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/CausalCorrection.hpp>
#include <harmos/latin/detail/SafeRelaxation.hpp>

namespace harmos::latin {
namespace {

// Of the largest residual of a load step, of the first correction and of later ones; what must have been reached is
// twice that.
constexpr double firstTarget = 0.1;
constexpr double laterTarget = 0.3;
constexpr double causalLimit = 2.0;
constexpr int maximumStages = 40;
constexpr int leastStages = 1;  // that must be affordable, with those that follow
// Linear stages of causal corrections that stagnated, before others take their place.
constexpr int stagesToWaste = 20;
// Of a run so far, from which on a march to a smaller residual is dearer than Newton corrections.
constexpr int stagesOfASlowMarch = 80;

// Of Newton corrections.
constexpr int leastVectors = 40;
constexpr int maximumVectors = 150;
constexpr double krylovTarget = 0.1;
constexpr double krylovLimit = 0.15;
// Of corrections that start close to the fixed point: what is left is in modes that hardly show in the residual.
constexpr double closeTarget = 0.02;
constexpr int smoothingIterations = 4;

constexpr int maximumCorrections = 8;
constexpr double hiddenLimit = 1.0;  // CausalCorrection::Result::hidden
// Corrections below this share of the accuracy may be round-off, which does not contract.
constexpr double settledShare = 0.1;
// Two corrections tell a contraction roughly: one that looks faster than this is not believed.
constexpr double leastContraction = 0.6;
// Slower contraction, or none, is that of round-off.
constexpr double steadyContraction = 0.8;
// From an error above this one a tangent can land anywhere; the next correction tells nothing of it.
constexpr double farAway = 0.3;

// A state so many times larger than the image of nothing, in which bodies are beyond reach, was not asked for.
constexpr double thrownSize = 1e4;

/// An iterate has thrown a body so far away that forces are lost beside k w and everything is small beside its way. The
/// image of nothing tells ways that are prescribed. `iterate` and `image` are those of alpha; leaves `image` as it was.
bool isThrown(FixedPoint& fixedPoint, const Iterate& iterate, const base::Matrix& alpha, base::Matrix& image) {
  if (!NaturalSizes(iterate).isBeyondReach()) return false;
  const base::Matrix nothing(alpha.numRows(), alpha.numCols());
  fixedPoint.apply(nothing, image);
  const double size = fixedPoint.metric().norm(image);
  fixedPoint.apply(alpha, image);
  return fixedPoint.metric().norm(alpha) > thrownSize * size;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

double fieldGap(const Iterate& state) {
  const std::vector<double>& area = state.layout().area();
  std::vector<double> sums(4, 0.0);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    const double* f = state.traction()[t];
    const double* hattedF = state.hattedTraction()[t];
    const double* w = state.trace()[t];
    const double* hattedW = state.hattedTrace()[t];
    for (std::size_t row = 0; row < area.size(); ++row) {
      sums[0] += area[row] * (f[row] - hattedF[row]) * (f[row] - hattedF[row]);
      sums[1] += area[row] * hattedF[row] * hattedF[row];
      sums[2] += area[row] * (w[row] - hattedW[row]) * (w[row] - hattedW[row]);
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

Certificate::Certificate(FixedPoint& fixedPoint, const std::vector<std::shared_ptr<const Response>>& responses,
                         double accuracy)
    : fixedPoint_(fixedPoint),
      responses_(responses),
      accuracy_(accuracy),
      stagesBefore_(fixedPoint.linearStage().stages()),
      newton_(fixedPoint) {
  if (fixedPoint.formulation() == Formulation::displacement) causal_ = std::make_unique<CausalCorrection>(fixedPoint);
}

Certificate::~Certificate() = default;

Certificate::Correction Certificate::correctCausally(const Iterate& iterate, const base::Matrix& alpha, int count,
                                                     int stages) {
  Correction result;
  result.state = alpha;
  const double target = count == 0 ? firstTarget : laterTarget;
  const int before = fixedPoint_.linearStage().stages();
  const CausalCorrection::Result step =
      causal_->correct(iterate, result.state, target, std::min(stages, maximumStages));
  result.reduction = step.reduction;
  result.reduced = step.reduction <= causalLimit * target;
  result.hidden = step.hidden;
  if (!result.reduced) wasted_ += fixedPoint_.linearStage().stages() - before;
  if (!(step.reduction <= 1.0)) result.state = alpha;
  return result;
}

Certificate::Correction Certificate::correctByNewton(const Iterate& iterate, const base::Matrix& alpha,
                                                     const base::Matrix& image, int count, double previous,
                                                     int stages) {
  Correction result;
  result.state = alpha;
  const bool isClose = count > 0 && previous <= settledShare * accuracy_;
  const NewtonCorrection::Result step =
      newton_.solve(iterate, alpha, image, isClose ? closeTarget : krylovTarget, std::min(stages, maximumVectors));
  result.reduction = step.reduction;
  result.reduced = step.reduction <= krylovLimit;
  result.hidden = step.hidden;
  if (result.reduced) result.state += step.step;
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

bool Certificate::isDearToGoOn() const {
  return wasted_ > stagesToWaste || fixedPoint_.linearStage().stages() - stagesBefore_ > stagesOfASlowMarch;
}

Certificate::Result Certificate::attempt(const Iterate& first, const base::Matrix& alpha, const base::Matrix& image,
                                         int stageLimit) {
  Result result = attemptOnce(first, alpha, image, stageLimit, false);
  for (int newton = 0; result.stagnated && causal_ && isDearToGoOn(); ++newton) {
    if (newton > 0) causal_.reset();
    const base::Matrix state(result.state);
    base::Matrix next(state.numRows(), state.numCols());
    const Iterate& iterate = fixedPoint_.apply(state, next);
    result = attemptOnce(iterate, state, next, stageLimit, true);
  }
  return result;
}

Certificate::Result Certificate::attemptOnce(const Iterate& first, const base::Matrix& alpha, const base::Matrix& image,
                                             int stageLimit, bool beginsWithNewton) {
  Result result;
  result.state = alpha;
  base::Matrix state(alpha);
  base::Matrix next(image);
  const Iterate* iterate = &first;
  fixedPoint_.shareTractions(state, next, accuracy_);
  auto before = std::make_unique<Snapshot>(*iterate, responses_);
  double previous = 0.0, hidden = 0.0;
  for (int count = 0; count < maximumCorrections; ++count) {
    const double gap = fieldGap(*iterate);
    const bool isCausal = causal_ && !(beginsWithNewton && count == 0);
    const int stages = stageLimit - fixedPoint_.linearStage().stages() - smoothingIterations - 2;
    if (stages < (isCausal ? leastStages : leastVectors)) return result;
    Correction step = isCausal ? correctCausally(*iterate, state, count, stages)
                               : correctByNewton(*iterate, state, next, count, previous, stages);
    if (!step.reduced) {
      result.state = step.state;
      result.conclusive = false;
      result.stagnated = isCausal;
      return result;
    }
    iterate = &fixedPoint_.apply(step.state, next);
    fixedPoint_.shareTractions(step.state, next, accuracy_);
    auto after = std::make_unique<Snapshot>(*iterate, responses_);
    std::vector<double> errors = after->distance(*before);
    const double error = largest(errors);
    if (count > 0) {
      result.contraction = error == 0.0 ? 0.0 : error / previous;
      const bool grew = result.contraction > 1.0 && error > settledShare * accuracy_;
      if (grew && !isCausal) return result;
      // The correction leaves a share of the residual, and so of the error.
      const double left = isCausal ? std::max(leastContraction, step.reduction) : step.reduction;
      const double kappa = std::clamp(result.contraction, left, steadyContraction);
      for (double& e : errors) e /= 1.0 - kappa;
      result.conclusive = !grew;
      if (!grew) result.estimates = errors;
      result.state = state;
      if (!grew && std::max(hidden, step.hidden) <= hiddenLimit && previous <= farAway &&
          largest(errors) <= accuracy_ && gap <= allowedGap * accuracy_ &&
          !isThrown(fixedPoint_, *iterate, step.state, next)) {
        result.claimed = true;
        return result;
      }
    }
    previous = error;
    hidden = step.hidden;
    state.assign(step.state);
    if (isCausal) {
      before = std::move(after);
    } else {
      iterate = &smooth(state, next);
      fixedPoint_.shareTractions(state, next, accuracy_);
      before = std::make_unique<Snapshot>(*iterate, responses_);
    }
    result.state = state;
    result.conclusive = false;
  }
  return result;
}

}  // namespace harmos::latin
