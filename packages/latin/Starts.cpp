#include <harmos/latin/Starts.hpp>

#include <cmath>
#include <vector>

#include <harmos/latin/AndersonAcceleration.hpp>

namespace harmos::latin {
namespace {

// A coarse start takes every third load step and stops where interpolation between them becomes the larger error.
constexpr int coarseSpacing = 3;
constexpr int coarseIterations = 20;
constexpr double coarseResidual = 2e-3;

// A march gives a load step up after so many iterations; what is missing is left to the iteration over all steps.
constexpr int marchIterations = 100;

/// Iterates the load steps that are selected until |T(alpha) - alpha| <= tolerance size(), at most `iterations` times.
/// `image` ends as T(alpha).
void iterate(FixedPoint& fixedPoint, base::Matrix& alpha, base::Matrix& image, int memory, double tolerance,
             int iterations, const std::function<const base::Matrix&()>& measure) {
  AndersonAcceleration acceleration(fixedPoint.metric(), memory);
  base::Matrix residual(alpha.numRows(), alpha.numCols());
  for (int i = 0; i < iterations; ++i) {
    fixedPoint.apply(alpha, image);
    residual.assign(image);
    residual -= alpha;
    if (fixedPoint.metric().norm(residual) <= tolerance * fixedPoint.metric().norm(measure())) return;
    acceleration.advance(alpha, image);
  }
}

bool isFinite(const FixedPoint& fixedPoint, const base::Matrix& alpha) {
  return std::isfinite(fixedPoint.metric().norm(alpha));
}

}  // namespace

void startFromCoarseSteps(FixedPoint& fixedPoint, base::Matrix& alpha, int memory) {
  const int steps = alpha.numCols();
  const int count = (steps + coarseSpacing - 1) / coarseSpacing;
  if (count < 3) return;
  std::vector<int> coarse;
  for (int i = 0; i < count; ++i) coarse.push_back(static_cast<int>(std::lround(i * (steps - 1.0) / (count - 1))));
  fixedPoint.select(coarse);
  base::Matrix some(alpha.numRows(), count);
  base::Matrix image(alpha.numRows(), count);
  iterate(fixedPoint, some, image, memory, coarseResidual, coarseIterations,
          [&]() -> const base::Matrix& { return image; });
  fixedPoint.selectAll();
  if (!isFinite(fixedPoint, some)) return;
  int left = 0;
  for (int t = 0; t < steps; ++t) {
    while (left + 2 < count && coarse[static_cast<std::size_t>(left) + 1] <= t) ++left;
    const double from = coarse[static_cast<std::size_t>(left)];
    const double share = (t - from) / (coarse[static_cast<std::size_t>(left) + 1] - from);
    for (int row = 0; row < alpha.numRows(); ++row) {
      alpha[t][row] = (1.0 - share) * some[left][row] + share * some[left + 1][row];
    }
  }
}

void marchThroughSteps(FixedPoint& fixedPoint, base::Matrix& alpha, int memory, double tolerance,
                       const std::function<bool()>& mustStop) {
  const int rows = alpha.numRows();
  base::Matrix state(rows, 1);
  base::Matrix image(rows, 1);
  for (int t = 0; t < alpha.numCols() && !mustStop(); ++t) {
    fixedPoint.select({t});
    for (int row = 0; row < rows; ++row) {
      state[0][row] = t < 2 ? alpha[0][row] : 2.0 * alpha[t - 1][row] - alpha[t - 2][row];
    }
    iterate(fixedPoint, state, image, memory, tolerance, marchIterations,
            [&]() -> const base::Matrix& { return fixedPoint.hattedTraction(); });
    if (!isFinite(fixedPoint, image)) break;
    fixedPoint.startFromHere();
    for (int row = 0; row < rows; ++row) alpha[t][row] = image[0][row];
  }
  fixedPoint.startUnloaded();
  fixedPoint.selectAll();
}

}  // namespace harmos::latin
