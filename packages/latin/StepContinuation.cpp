#include <harmos/latin/StepContinuation.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

constexpr double firstPart = 0.25;
// Newton's steps of a part; one that took no more than a few lets the next part be longer.
constexpr int mostSteps = 12;
constexpr double longer = 1.5;
constexpr double shorter = 0.5;

/// to = a + ratio (a - b), one column each.
void extrapolate(const base::Matrix& a, const base::Matrix& b, double ratio, base::Matrix& to) {
  for (int row = 0; row < a.numRows(); ++row) to(row, 0) = a(row, 0) + ratio * (a(row, 0) - b(row, 0));
}

}  // namespace

StepContinuation::Result StepContinuation::solve(int step, const base::Matrix& before, base::Matrix& state,
                                                 double target, const std::function<bool()>& mustStop) {
  const int rows = before.numRows();
  base::Matrix beta(rows, 1), loads(rows, 1), offset(rows, 1);
  // What the loads of this step add to those of the one before.
  if (step > 0) {
    fixedPoint_.select({step - 1});
    fixedPoint_.solveLinear(before, loads);
    fixedPoint_.select({step});
  }
  fixedPoint_.solveLinear(before, beta);
  for (int row = 0; row < rows; ++row) loads(row, 0) = beta(row, 0) - loads(row, 0);

  base::Matrix fromState(before), fromBeta(beta);  // the last solution
  base::Matrix earlierState(before), earlierBeta(beta), tried(rows, 1), triedBeta(rows, 1);
  Result result;
  double part = firstPart, lastPart = 0.0;
  while (result.share < 1.0 && part >= leastPart && !(mustStop && mustStop())) {
    const double length = std::min(part, 1.0 - result.share), end = result.share + length;
    const double ratio = lastPart > 0.0 ? length / lastPart : 0.0;
    extrapolate(fromState, earlierState, ratio, tried);
    extrapolate(fromBeta, earlierBeta, ratio, triedBeta);
    for (int row = 0; row < rows; ++row) offset(row, 0) = (end - 1.0) * loads(row, 0);
    if (!newton_.solveWith(offset, tried, triedBeta, target, mostSteps, mustStop).isReached) {
      part = shorter * length;
      continue;
    }
    earlierState.assign(fromState);
    earlierBeta.assign(fromBeta);
    fromState.assign(tried);
    fromBeta.assign(triedBeta);
    lastPart = length;
    part = longer * length;
    result.share = end;
    ++result.parts;
  }
  result.isReached = result.share >= 1.0;
  state.assign(fromState);
  return result;
}

}  // namespace harmos::latin
