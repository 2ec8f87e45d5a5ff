#include <harmos/study/StudyCost.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/parametric/CalibratedSchedule.hpp>
#include <harmos/parametric/ParametricStudy.hpp>
#include <harmos/parametric/StudySolver.hpp>
#include <harmos/study/MeshErrorSample.hpp>
#include <harmos/study/StudyGroup.hpp>

namespace harmos::study {

namespace {

// Linear stages over those of a run: of a configuration that is certified by itself, from another one; of one that
// calibrates a study, with the attempts that come to nothing; of one that starts from others that are next to it, at 1
// %, how that grows with every decade of the accuracy and with their distance in the ranges of the parameters; and
// where all laws are affine.
constexpr double alone = 1.8, calibration = 1.6, amongOthers = 0.05, growthPerDecade = 0.08, growthWithDistance = 0.87,
                 affine = 0.15, affineAlone = 1.0;
constexpr double usualAccuracy = 1e-2;
// Marches from neighbours differ: from this share of the most stages on that they may take, some need more.
constexpr double spread = 0.6;
// None takes fewer: its start, and the state that is delivered.
constexpr double leastStages = 2.0;
// How often all responses are asked for: of a state that is accepted by the indicators, the result, and what its ranges
// are compared with; of a calibration by two states on its way and their snapshots, its certificate and the state that
// is remembered. As often as all displacements of a calibration are, in whichever way they are found.
constexpr double evaluationsOfResult = 3.0, evaluationsOfCalibration = 10.0, looksOfCalibration = 6.0;
// Of a configuration that marches beside others: fields of all load steps; and columns of the one at hand, which are
// directions of its start with their images, and what the acceleration remembers.
constexpr double fieldsOfPlace = 5.0, columnsOfPlace = 60.0;
// Of a configuration besides: its scene is checked and its laws are made. Of a curve in the files; for every
// configuration, and for every number of it.
constexpr double configurationSeconds = 2e-3, curveSeconds = 6e-4, recordSeconds = 1.8e-5, numberSeconds = 3e-7;
constexpr double curveBytes = 1.4e5, recordBytes = 300.0, numberBytes = 48.0;

/// What a study of one kind does.
struct StudyWork {
  double stages = 0.0, stageSeconds = 0.0;             // linear ones of a configuration, and one of them
  double certified = 0.0;                              // configurations with a certificate of their own
  double corrections = 0.0;                            // least squares of these, over those of a run
  double evaluations = 0.0, looks = 0.0, loads = 0.0;  // of responses, whole displacements and loads, in all
};

/// Distance of neighbours, as if configurations were a grid over the free parameters that vary, in their ranges.
double distanceOf(const Study& study, double count) {
  int varying = 0;
  for (std::size_t p = 0; p < study.parameters.size(); ++p) {
    if (!study.parameters[p].formula.empty()) continue;
    const auto isOther = [&](const design::Configuration& one) {
      return one.values[p] != study.configurations.front().values[p];
    };
    if (std::any_of(study.configurations.begin(), study.configurations.end(), isOther)) ++varying;
  }
  if (varying == 0) return 0.0;
  const double along = std::pow(count, 1.0 / varying);
  return 1.0 / std::max(1.0, along - 1.0);
}

/// Whether configurations have loads of their own: tractions, or displacements that boundaries prescribe.
bool changeLoads(const Study& study) {
  const auto isLoad = [&](const Effect& effect) {
    if (effect.kind == Effect::Kind::loads) return true;
    const auto law = study.scene.laws.find(effect.name);
    if (effect.target != Effect::Target::law || effect.entry.rfind("Boundaries/", 0) != 0 ||
        law == study.scene.laws.end() || !law->second->isAffine())
      return false;
    const auto components = laws::affineComponents(*law->second, 0);
    return std::any_of(components.begin(), components.end(),
                       [](const laws::AffineComponent& component) { return std::isinf(component.stiffness); });
  };
  return std::any_of(study.parameters.begin(), study.parameters.end(), [&](const StudyParameter& one) {
    return std::any_of(one.effects.begin(), one.effects.end(), isLoad);
  });
}

/// Where each configuration is certified.
StudyWork workOfCertificates(double count, const scene::CostEstimate& cost) {
  StudyWork work;
  // The first one starts from nothing. Least squares grow with the square of the stages.
  const double others = std::max(0.0, count - 1.0), more = cost.isAffine ? affineAlone : alone;
  work.stages = (1.0 + others * more) / std::max(1.0, count) * cost.stages;
  work.corrections = 1.0 + others * more * more;
  work.stageSeconds = cost.stages > 0.0 ? cost.stagesSeconds() / cost.stages : 0.0;
  work.certified = work.loads = count;
  work.evaluations = work.looks = scene::CostEstimate::evaluations * count;
  return work;
}

/// Where a few calibrate, and the others march from their neighbours.
StudyWork workOfMarches(const Study& study, double count, const scene::CostEstimate& cost,
                        const latin::LatinOptions& options, bool areTogether) {
  StudyWork work;
  const double calibrations = parametric::CalibratedSchedule::calibrationsUntil(static_cast<int>(count)),
               decades = std::max(0.0, std::log10(usualAccuracy / options.accuracy)),
               further = growthPerDecade * decades,
               near = std::min(alone, amongOthers + further + growthWithDistance * distanceOf(study, count));
  const double run = cost.stages - cost.otherStages, march = (cost.isAffine ? affine + further : near) * run;
  // Marches that are not through after so many stages are given up for a certificate.
  constexpr double most = parametric::CalibratedSchedule::stagesFromNeighbours;
  const double givenUp = cost.isAffine ? 0.0 : std::clamp(march / most - spread, 0.0, 1.0);
  const double shareOfCalibrations = cost.isAffine ? 0.0 : calibration * calibrations / count;
  work.stages = std::max(leastStages,
                         shareOfCalibrations * run + (1.0 - givenUp) * march + givenUp * (std::min(march, most) + run));
  work.stageSeconds = cost.stageSeconds;
  // Marches from neighbours solve in double precision where the accuracy asks for it.
  if (!options.stages.solver.invertTrace)
    work.stageSeconds += cost.steps * cost.exactSolves.seconds(1.0) - cost.readSeconds;
  const double fromNeighbours = givenUp * (count - calibrations);
  work.certified = std::min(count, calibration / alone * calibrations + fromNeighbours);
  work.corrections = work.certified;
  work.evaluations = evaluationsOfResult * count + (evaluationsOfCalibration - evaluationsOfResult) * calibrations +
                     scene::CostEstimate::evaluations * fromNeighbours;
  // Of more load steps than are looked at together none is still there when it is asked for again.
  work.looks = cost.steps > latin::stepsAtOnce ? work.evaluations
                                               : count + (looksOfCalibration - 1.0) * calibrations +
                                                     scene::CostEstimate::evaluations * fromNeighbours;
  // Those of a configuration that marches beside others are put back when it has come through.
  work.loads = areTogether ? 2.0 * count : count;
  return work;
}

}  // namespace

latin::LatinOptions solverOptions(const Study& study) {
  return parametric::optionsForStudy(study.scene.solver, study.configurations.size(),
                                     static_cast<int>(study.scene.times.size()));
}

int mostConfigurations(const Study& study) {
  if (const auto* adaptive = study.design.as<AdaptiveOptions>()) return adaptive->refinement.maximumCount;
  if (const auto* interpolation = study.design.as<InterpolationOptions>())
    return interpolation->largestCount + interpolation->holdOuts.count;
  return static_cast<int>(study.configurations.size());
}

StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, const ChaosCost& chaos) {
  StudyCost result;
  result.solves = 1.0;
  for (const StochasticPlan::Sweep& sweep : study.stochastic->sweeps)
    result.solves *= static_cast<double>(sweep.coefficients.size());
  result.stages = chaos.iterations;
  result.seconds = cost.startSeconds + cost.factorSeconds + cost.resultSeconds() + result.solves * chaos.solveSeconds;
  if (study.stochastic->holdOuts > 0) {
    const double ofHoldOut = cost.solveSeconds() + cost.askingSeconds() + configurationSeconds;
    result.seconds += cost.factorSeconds + study.stochastic->holdOuts * ofHoldOut;
  }
  return result;
}

StudyCost estimateStudy(const Study& study, const scene::CostEstimate& cost, int configurations) {
  StudyCost result;
  double once = cost.startSeconds + cost.factorSeconds + cost.resultSeconds();
  const double groups =
      std::max(1.0, static_cast<double>(groupByOperators(study.parameters, study.configurations).size()));
  result.solves = configurations;
  result.bytes = std::min(
      result.solves * parametric::SolvedStates::bytesOf(static_cast<double>(cost.interfaceUnknowns), cost.steps),
      parametric::StudySolver::memoryForStates);
  const latin::LatinOptions options = solverOptions(study);
  const bool marches = !parametric::certifiesEach(options, static_cast<std::size_t>(configurations));
  if (marches) {
    result.sideBySide = parametric::CalibratedSchedule::sideBySide(configurations, study.sideBySide);
    result.bytes += (result.sideBySide - 1) * sizeof(double) * static_cast<double>(cost.interfaceUnknowns) *
                    (fieldsOfPlace * cost.steps + columnsOfPlace);
  }
  result.bytes += cost.responses * (curveBytes + result.solves * (recordBytes + numberBytes * cost.steps));
  const StudyWork work = marches ? workOfMarches(study, result.solves, cost, options, result.sideBySide > 1)
                                 : workOfCertificates(result.solves, cost);
  result.stages = work.stages;
  once += std::max(0.0, static_cast<double>(MeshErrorSample::mostOf(static_cast<std::size_t>(configurations))) - 1.0) *
          cost.meshErrorSeconds;
  result.seconds =
      once + (groups - 1.0) * cost.factorSeconds + work.certified * cost.staticsSeconds +
      work.corrections * cost.correctionSeconds + work.looks * cost.lookSeconds +
      work.evaluations * cost.evaluationSeconds() +
      (changeLoads(study) ? work.loads * cost.loadSeconds + (work.loads - result.solves) * work.stageSeconds : 0.0) +
      result.solves * (configurationSeconds + work.stages * work.stageSeconds) +
      cost.responses * (curveSeconds + result.solves * (recordSeconds + numberSeconds * cost.steps));
  return result;
}

}  // namespace harmos::study
