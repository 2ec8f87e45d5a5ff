#include <harmos/study/StudyCost.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/study/StudyGroup.hpp>

namespace harmos::study {

namespace {

// Stages of a configuration over those of a run: certified by itself; with neighbours at a distance of h of the range
// of its parameters, nearness h, within bounds, calibration included; where all laws are affine.
constexpr double alone = 1.8, nearness = 1.6, farthest = 1.0, nearest = 0.1, affine = 0.2;
// Below so many configurations each is certified, see parametric::CertifiedSchedule.
constexpr double fewConfigurations = 10.0;
// Of a configuration besides: its scene is checked and its laws are made.
constexpr double configurationSeconds = 3e-3;

}  // namespace

StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, const ChaosCost* chaos) {
  StudyCost result;
  const double once = cost.startSeconds + cost.factorSeconds + cost.resultSeconds;
  if (chaos != nullptr) {
    result.solves = 1.0;
    for (const StochasticPlan::Sweep& sweep : study.stochastic->sweeps)
      result.solves *= static_cast<double>(sweep.coefficients.size());
    result.stages = ChaosCost::usualIterations;
    result.seconds = once + result.solves * chaos->solveSeconds +
                     study.stochastic->holdOuts * (cost.stages * cost.stageSeconds + configurationSeconds);
    return result;
  }
  const double parameters = std::max(1.0, static_cast<double>(study.parameters.size()));
  const double groups =
      std::max(1.0, static_cast<double>(groupByOperators(study.parameters, study.configurations).size()));
  result.solves = static_cast<double>(study.configurations.size());
  const double distance = std::pow(std::max(result.solves, 1.0), -1.0 / parameters);
  const double share = result.solves < fewConfigurations ? alone
                       : cost.isAffine                   ? affine
                                                         : std::clamp(nearness * distance, nearest, farthest);
  result.stages = share * cost.stages;
  result.seconds = once + (groups - 1.0) * cost.factorSeconds +
                   result.solves * (configurationSeconds + result.stages * cost.stageSeconds);
  return result;
}

}  // namespace harmos::study
