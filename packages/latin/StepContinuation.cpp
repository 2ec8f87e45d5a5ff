#include <harmos/latin/StepContinuation.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

constexpr double firstPart = 0.25;
// Where loads are found, a state that does not fit the jump asks for loads many times as large, which would break
// joints: the first part is so small that they bear that, and extrapolation does the rest.
constexpr double firstPartOfPath = 1.0 / 65536.0;
constexpr double leastPartOfPath = 1.0 / 262144.0;
// Newton's steps of a part; one that took no more than a few lets the next part be longer.
constexpr int mostSteps = 12;
// A residual so many times above what the forces of its own state ask for is near enough; one that is not goes to so
// little of itself at most.
constexpr double nearEnough = 1.5;
constexpr double smallestFall = 1e-3;
constexpr double longer = 1.5;
constexpr double shorter = 0.5;

/// to = a + ratio (a - b), one column each.
void extrapolate(const base::Matrix& a, const base::Matrix& b, double ratio, base::Matrix& to) {
  for (int row = 0; row < a.numRows(); ++row) to(row, 0) = a(row, 0) + ratio * (a(row, 0) - b(row, 0));
}

}  // namespace

double StepContinuation::forceOf(const base::Matrix& offset, const base::Matrix& beta) const {
  base::Matrix shifted(beta), force(beta.numRows(), 1);
  shifted += offset;
  // Not half of alpha + beta: motions that T does not feel are in alpha alone.
  fixedPoint_.pointwiseStage().begin();
  fixedPoint_.pointwiseStage().solveColumn(0, shifted, force);
  return fixedPoint_.metric().norm(force);
}

bool StepContinuation::solveBoth(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta, double target,
                                 const std::function<bool()>& mustStop) {
  for (const StepNewton::StepLength length : {StepNewton::StepLength::damped, StepNewton::StepLength::whole}) {
    if (newton_.solveWith(offset, state, beta, target, mostSteps, length, mustStop).isReached) return true;
  }
  return false;
}

bool StepContinuation::solvePart(const base::Matrix& offset, base::Matrix& state, base::Matrix& beta, double target,
                                 double share, const std::function<bool()>& mustStop) {
  if (!fixedPoint_.assembly().path) {
    return solveBoth(offset, state, beta, target, mustStop);
  }
  // What is too large at first shrinks with the forces.
  double asked = std::max(target, share * forceOf(offset, beta));
  for (;;) {
    if (!solveBoth(offset, state, beta, asked, mustStop)) return false;
    const double needed = std::max(target, share * forceOf(offset, beta));
    if (asked <= std::max(nearEnough * needed, fixedPoint_.roundOff(fixedPoint_.metric().norm(state)))) return true;
    asked = std::max(needed, smallestFall * asked);
  }
}

StepContinuation::Result StepContinuation::solve(int step, const base::Matrix& before, const Way& way,
                                                 base::Matrix& state, double target, double share,
                                                 const std::function<bool()>& mustStop) {
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
  double lastPart = 0.0;
  if (way.times != 0.0) {
    earlierState.assign(way.from);
    fixedPoint_.solveLinear(way.from, earlierBeta);
    lastPart = 1.0 / way.times;
  }
  Result result;
  const bool isPath = fixedPoint_.assembly().path.has_value();
  const double least = isPath ? leastPartOfPath : leastPart;
  double part = isPath && step == 0 ? firstPartOfPath : firstPart;
  while (result.share < 1.0 && part >= least && !(mustStop && mustStop())) {
    const double length = std::min(part, 1.0 - result.share), end = result.share + length;
    const double ratio = lastPart != 0.0 ? length / lastPart : 0.0;
    extrapolate(fromState, earlierState, ratio, tried);
    extrapolate(fromBeta, earlierBeta, ratio, triedBeta);
    for (int row = 0; row < rows; ++row) offset(row, 0) = (end - 1.0) * loads(row, 0);
    if (!solvePart(offset, tried, triedBeta, target, share, mustStop)) {
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
