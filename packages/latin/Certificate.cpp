#include <harmos/latin/Certificate.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/detail/SafeRelaxation.hpp>

namespace harmos::latin {
namespace {

constexpr int leastVectors = 40;  // that must be affordable
constexpr int maximumVectors = 150;
constexpr double krylovTarget = 0.1;
constexpr double krylovLimit = 0.15;
constexpr double hiddenLimit = 1.0;  // NewtonCorrection::Result::hidden
// Of corrections that start close to the fixed point: what is left is in modes that hardly show in the residual.
constexpr double closeTarget = 0.02;
constexpr int smoothingIterations = 4;
constexpr int maximumCorrections = 5;
// Corrections below this share of the accuracy may be round-off, which does not contract.
constexpr double settledShare = 0.1;
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

Certificate::Result Certificate::attempt(const Iterate& first, const base::Matrix& alpha, const base::Matrix& image,
                                         int stageLimit) {
  Result result;
  result.state = alpha;
  base::Matrix state(alpha);
  base::Matrix next(image);
  const Iterate* iterate = &first;
  auto before = std::make_unique<Snapshot>(*iterate, responses_);
  double previous = 0.0;
  for (int correction = 0; correction < maximumCorrections; ++correction) {
    const double gap = fieldGap(*iterate);
    const int vectors =
        std::min(maximumVectors, stageLimit - fixedPoint_.linearStage().stages() - smoothingIterations - 2);
    if (vectors < leastVectors) return result;
    const bool isClose = correction > 0 && previous <= settledShare * accuracy_;
    const NewtonCorrection::Result step =
        newton_.solve(*iterate, state, next, isClose ? closeTarget : krylovTarget, vectors);
    if (step.reduction > krylovLimit) return result;
    base::Matrix corrected(state);
    corrected += step.step;
    iterate = &fixedPoint_.apply(corrected, next);
    auto after = std::make_unique<Snapshot>(*iterate, responses_);
    std::vector<double> errors = after->distance(*before);
    const double error = largest(errors);
    if (correction > 0) {
      result.contraction = error == 0.0 ? 0.0 : error / previous;
      if (result.contraction > 1.0 && error > settledShare * accuracy_) return result;
      for (double& e : errors) e /= 1.0 - std::min(result.contraction, steadyContraction);
      result.conclusive = true;
      result.estimates = errors;
      result.state = state;
      if (step.hidden <= hiddenLimit && previous <= farAway && largest(errors) <= accuracy_ &&
          gap <= allowedGap * accuracy_ && !isThrown(fixedPoint_, *iterate, corrected, next)) {
        result.claimed = true;
        return result;
      }
    }
    previous = error;
    state.assign(corrected);
    for (int i = 0; i < smoothingIterations; ++i) {
      for (int t = 0; t < state.numCols(); ++t) {
        for (int row = 0; row < state.numRows(); ++row) state[t][row] = relaxSafely(state[t][row], next[t][row]);
      }
      iterate = &fixedPoint_.apply(state, next);
    }
    result.state = state;
    result.conclusive = false;
    before = std::make_unique<Snapshot>(*iterate, responses_);
  }
  return result;
}

}  // namespace harmos::latin
