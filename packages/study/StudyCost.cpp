#include <harmos/study/StudyCost.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/parametric/CalibratedSchedule.hpp>
#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/study/StudyGroup.hpp>

namespace harmos::study {

namespace {

// Linear stages over those of a run: of a configuration that is certified by itself, of one that calibrates a study,
// with the attempts that come to nothing, of one that starts from others that are next to it, at 1 %, how that grows
// with their distance in the ranges of the parameters, and where all laws are affine; and the power of the accuracy
// that the one among others falls with.
constexpr double alone = 1.8, calibration = 1.6, amongOthers = 0.09, growthWithDistance = 0.87, affine = 0.2;
constexpr double usualAccuracy = 1e-2, powerOfAccuracy = 0.3;
// Below so many configurations each is certified, see parametric::CertifiedSchedule.
constexpr double fewConfigurations = 10.0;
// Of a configuration that marches beside others: fields of all load steps; and columns of the one at hand, which are
// directions of its start with their images, and what the acceleration remembers.
constexpr double fieldsOfPlace = 5.0, columnsOfPlace = 60.0;
// Of a configuration besides: its scene is checked and its laws are made.
constexpr double configurationSeconds = 3e-3;

/// Distance of neighbours, as if configurations were a grid over the free parameters that vary, in their ranges.
double distanceOf(const Study& study) {
  int varying = 0;
  for (std::size_t p = 0; p < study.parameters.size(); ++p) {
    if (!study.parameters[p].formula.empty()) continue;
    const auto isOther = [&](const design::Configuration& one) {
      return one.values[p] != study.configurations.front().values[p];
    };
    if (std::any_of(study.configurations.begin(), study.configurations.end(), isOther)) ++varying;
  }
  if (varying == 0) return 0.0;
  const double along = std::pow(static_cast<double>(study.configurations.size()), 1.0 / varying);
  return 1.0 / std::max(1.0, along - 1.0);
}

}  // namespace

latin::LatinOptions solverOptions(const Study& study) {
  return parametric::optionsForStudy(study.scene.solver, study.configurations.size(),
                                     static_cast<int>(study.scene.times.size()));
}

StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, const ChaosCost* chaos) {
  StudyCost result;
  const double once = cost.startSeconds + cost.factorSeconds + cost.resultSeconds();
  if (chaos != nullptr) {
    result.solves = 1.0;
    for (const StochasticPlan::Sweep& sweep : study.stochastic->sweeps)
      result.solves *= static_cast<double>(sweep.coefficients.size());
    result.stages = ChaosCost::usualIterations;
    result.seconds = once + result.solves * chaos->solveSeconds +
                     study.stochastic->holdOuts * (cost.solveSeconds() + configurationSeconds);
    return result;
  }
  const double groups =
      std::max(1.0, static_cast<double>(groupByOperators(study.parameters, study.configurations).size()));
  result.solves = static_cast<double>(study.configurations.size());
  result.bytes = std::min(
      result.solves * parametric::SolvedStates::bytesOf(static_cast<double>(cost.interfaceUnknowns), cost.steps),
      parametric::StudySolver::memoryForStates);
  if (result.solves >= fewConfigurations) {
    result.sideBySide = parametric::CalibratedSchedule::sideBySide(static_cast<int>(result.solves), study.sideBySide);
    result.bytes += (result.sideBySide - 1) * sizeof(double) * static_cast<double>(cost.interfaceUnknowns) *
                    (fieldsOfPlace * cost.steps + columnsOfPlace);
  }
  const double calibrations =
      calibration * parametric::CalibratedSchedule::calibrationsUntil(static_cast<int>(result.solves));
  const double near = amongOthers * std::pow(usualAccuracy / solverOptions(study).accuracy, powerOfAccuracy) +
                      growthWithDistance * distanceOf(study);
  const double share = result.solves < fewConfigurations ? alone
                       : cost.isAffine                   ? affine
                                                         : calibrations / result.solves + std::min(near, alone);
  result.stages = share * cost.stages;
  // Marches from neighbours solve in double precision, which reads twice as much, where the accuracy asks for it.
  const bool readsDouble = result.solves >= fewConfigurations && !solverOptions(study).stages.solver.invertTrace;
  const double stageSeconds = cost.stageSeconds + (readsDouble ? cost.readSeconds : 0.0);
  const double certified =
      result.solves < fewConfigurations ? result.solves : std::min(result.solves, calibrations / alone);
  double looks = cost.steps > 0 ? solverOptions(study).stages.solver.wholeSolves / cost.steps : 0.0;
  // What loads do by themselves takes another solve, where each configuration has its own.
  if (std::any_of(study.parameters.begin(), study.parameters.end(),
                  [](const StudyParameter& one) { return one.effect == Effect::Kind::loads; }))
    looks += result.solves;
  result.seconds = once + (groups - 1.0) * cost.factorSeconds +
                   certified * (cost.staticsSeconds + cost.correctionSeconds) + looks * cost.lookSeconds +
                   result.solves * (configurationSeconds + result.stages * stageSeconds);
  return result;
}

}  // namespace harmos::study
