#include <harmos/latin/detail/SofteningSteps.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Numerals.hpp>
#include <harmos/latin/Extrapolation.hpp>
#include <harmos/latin/StepContinuation.hpp>
#include <harmos/latin/detail/ResultRemarks.hpp>

namespace harmos::latin {
namespace {

// Steps of Newton's method for a whole load step; then the load step is divided.
constexpr int mostSofteningSteps = 15;

}  // namespace

SofteningSteps::SofteningSteps(FixedPoint& fixedPoint)
    : fixedPoint_(fixedPoint),
      isPath_(fixedPoint.assembly().path.has_value()),
      parts_(static_cast<std::size_t>(fixedPoint.assembly().steps()), 1),
      snaps_(static_cast<std::size_t>(fixedPoint.assembly().steps()), false) {}

bool SofteningSteps::solve(int step, const Iterate& iterate, const base::Matrix& alpha, base::Matrix& state,
                           const Goal& goal, StepNewton& newton, const std::function<bool()>& mustStop) {
  const int rows = state.numRows();
  base::Matrix beta(rows, 1), whole(rows, 1), before(rows, 1);
  beta.assign(iterate.beta());  // a copy: the field goes with the next solve
  whole.assign(state);
  const base::Matrix none(rows, 1);
  const auto length = StepNewton::StepLength::damped;
  if (newton.solveWith(none, whole, beta, goal.residual, mostSofteningSteps, length, mustStop).isReached) {
    state.assign(whole);
    return true;
  }
  const double share = goal.residual / goal.forces;
  const double least = isPath_ ? share * goal.largest : goal.residual;
  // Parts add round-off to what they have come to already, and end where the joint has snapped.
  const bool isKnown = snaps_[step] || (isPath_ && parts_[step] > 1);
  if (!isKnown) {
    if (step > 0) std::copy_n(alpha[step - 1], rows, before[0]);
    StepContinuation::Way way{base::Matrix(rows, 1)};
    if (isPath_) way.times = growthAlong(fixedPoint_.assembly().path->values, step);
    if (step > 1) std::copy_n(alpha[step - 2], rows, way.from[0]);
    const StepContinuation::Result result =
        StepContinuation(fixedPoint_, newton).solve(step, before, way, state, least, share, mustStop);
    share_ = result.share;
    if (result.isReached) {
      parts_[step] = std::max(parts_[step], result.parts);
      return true;
    }
  }
  fixedPoint_.solveLinear(state, beta);
  if (!newton.settle(state, beta, least, mustStop).isReached) return false;
  snaps_[step] = true;
  return true;
}

std::string SofteningSteps::describeUnsolved(int step) const {
  const assembly::Assembly& assembly = fixedPoint_.assembly();
  std::string text = "load step " + std::to_string(step + 1) + ", time " + base::toText(assembly.times[step]) +
                     ", has no solution near that of the load step before";
  if (share_ < 1.0) {
    text += ": it could be followed through " + base::toText(std::round(1e3 * share_) / 10.0) +
            " % of the load step, where the joint snaps";
  }
  text += "; the laws of " + namesOfSoftening(assembly) + " soften";
  return text + (isPath_ ? ": control what the loads open most, such as the mouth of a crack, go on in smaller load "
                           "steps, or let the Scale of the Search Direction be 0.1 or 0.01, as slender parts need it"
                         : ": let the size of the loads be found (Path Following), or refine the mesh along the joint "
                           "or lower its strength, as a crack needs that jumps from point to point");
}

}  // namespace harmos::latin
