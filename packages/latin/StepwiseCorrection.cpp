#include <harmos/latin/StepwiseCorrection.hpp>

#include <algorithm>

#include <harmos/latin/StepContinuation.hpp>

namespace harmos::latin {

bool StepwiseCorrection::findAnotherWay(int step, const base::Matrix& alpha, base::Matrix& state, double target,
                                        const std::function<bool()>& mustStop) {
  if (!fixedPoint_.assembly().softens()) return false;
  base::Matrix given(state), beta(state.numRows(), 1);
  base::Matrix before(alpha.numRows(), 1);
  if (step > 0) std::copy_n(alpha[step - 1], alpha.numRows(), before[0]);
  const StepContinuation::Way nothingKnown{base::Matrix(alpha.numRows(), 1)};
  const bool isFollowed =
      StepContinuation(fixedPoint_, newton_).solve(step, before, nothingKnown, state, target, 0.0, mustStop).isReached;
  if (isFollowed) return true;
  state.assign(given);
  fixedPoint_.solveLinear(state, beta);
  return newton_.settle(state, beta, target, mustStop).isReached;
}

StepwiseCorrection::Result StepwiseCorrection::correct(const Iterate& iterate, base::Matrix& alpha, double target,
                                                       const std::vector<double>& targets, int stageLimit) {
  const int rows = alpha.numRows();
  // A copy: the iterate's fields are overwritten from the first load step on.
  const base::Matrix images(Teuchos::Copy, iterate.beta().values(), iterate.beta().stride(), rows, alpha.numCols());
  base::Matrix state(rows, 1), beta(rows, 1), image(rows, 1);
  // All load steps are met from the unloaded state again at the end, also when a law throws.
  const FixedPoint::AllStepsAtEnd restore(fixedPoint_);
  fixedPoint_.startUnloaded();
  const auto mustStop = [&] { return fixedPoint_.linearStage().stages() >= stageLimit; };
  Result result;
  for (int t = 0; t < alpha.numCols(); ++t) {
    fixedPoint_.select({t});
    std::copy_n(alpha[t], rows, state[0]);
    std::copy_n(images[t], rows, beta[0]);
    StepNewton::Result step = newton_.solve(state, beta, std::min(target, targets[t]), mustStop);
    if (!step.isReached && targets[t] < target) step = newton_.solve(state, beta, target, mustStop);
    const bool isMet =
        step.isReached ? newton_.settleSoftMotions(state, target) : findAnotherWay(t, alpha, state, target, mustStop);
    if (!isMet) return result;
    result.smallestSingularValue = std::min(result.smallestSingularValue, step.smallestSingularValue);
    std::copy_n(state[0], rows, alpha[t]);
    fixedPoint_.pointwiseStage().accept();
    fixedPoint_.startFromHere();
  }
  result.isReached = true;
  return result;
}

}  // namespace harmos::latin
