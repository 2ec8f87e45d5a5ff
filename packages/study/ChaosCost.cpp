#include <harmos/study/ChaosCost.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/ProblemCost.hpp>

namespace harmos::study {

namespace {

constexpr double entryBytes = 8.0;
// How often all displacements of an expansion are asked for: by responses, and for the fields in the files.
constexpr double wholesOfSolution = 2.0;
// Iterations for every decade of the accuracy, where all laws are affine and where not.
constexpr double iterationsOfAffine = 8.0, iterationsOfOthers = 33.0;
// Galerkin's solution does not depend on the search direction: it is left only for a clear gain.
constexpr double dearer = 2.0, secondsThatCount = 1.0;

double power(const std::vector<int>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 1.0, std::multiplies<>());
}

double termsOf(const StochasticPlan& plan) {
  double terms = 1.0;
  for (int i = 1; i <= plan.variables->dimension(); ++i) terms *= static_cast<double>(plan.order + i) / i;
  return terms;
}

double sizeOf(const input::InputNode& node) {
  double size = 1.0;
  for (const input::InputNode& child : node.children) size += sizeOf(child);
  return size;
}

std::string described(const ChaosCost& cost, int ranks) {
  std::ostringstream text;
  text << std::setprecision(0) << std::fixed << cost.points << " points, about " << std::setprecision(2)
       << std::defaultfloat << cost.bytesOf(ranks) / 1e9 << " GB" << (ranks > 1 ? " per rank" : "") << " and "
       << cost.seconds << " CPU seconds";
  return text.str();
}

}  // namespace

ChaosCost estimateChaos(const Study& study, const scene::Problem& problem, const scene::CostEstimate& cost,
                        bool isGalerkin) {
  // Of the program with its libraries; vectors and shared laws as the GNU library allocates them.
  constexpr double programBytes = 50e6, vectorBytes = 40.0, pointerBytes = 32.0, lawBytes = 160.0;
  constexpr double historiesBytes = 72.0, historyCopies = 3.0;
  // Fields of all polynomials: Anderson's method keeps twice its memory, the rest are states, images and snapshots.
  constexpr double otherFields = 14.0;
  // Fits of measured times: of a scene per entry of its input, of a law and of the projection at a point.
  constexpr double secondsPerEntry = 3e-6, secondsPerLaw = 20e-9, secondsPerProduct = 1.2e-9, secondsPerSpring = 2e-9;
  // Least squares of all polynomials are made together.
  constexpr double shareOfLeastSquares = 0.3;

  const StochasticPlan& plan = *study.stochastic;
  const assembly::Assembly& assembly = problem.assembly;
  const double dimension = plan.variables->dimension(), steps = assembly.steps();
  ChaosCost result;
  result.isGalerkin = isGalerkin;
  result.terms = termsOf(plan);
  result.iterations = (assembly.isAffine() ? iterationsOfAffine : iterationsOfOthers) *
                      std::max(1.0, std::log10(1.0 / study.scene.solver.accuracy));
  result.points = power(gaussPoints(*plan.variables, plan.order, plan.points, isGalerkin));

  double perPoint = 2.0 * (vectorBytes + entryBytes * dimension) + vectorBytes + 2.0 * entryBytes * result.terms;
  double mostPairs = 0.0, perIteration = 0.0;
  for (const assembly::Interface& interface : assembly.interfaces) {
    const double pairs = interface.pairs();
    const bool hasRandomLaw = changeLawOf(study.parameters, interface.name);
    perPoint += pointerBytes + (hasRandomLaw ? lawBytes + 3.0 * entryBytes * steps : 0.0);
    if (interface.law->prescribesTraction()) continue;
    perPoint += historiesBytes + historyCopies * entryBytes * pairs * interface.law->historySize();
    mostPairs = std::max(mostPairs, pairs);
    perIteration += steps * pairs *
                    (isGalerkin && hasRandomLaw ? secondsPerSpring * result.terms * result.terms
                                                : result.points * (secondsPerLaw + secondsPerProduct * result.terms));
  }
  perPoint += 6.0 * entryBytes * mostPairs;
  // Samples of the responses, of which polynomials and germs are kept.
  const double samples = study.statistics.samples * (vectorBytes + entryBytes * (dimension + result.terms));
  result.replicated = programBytes + result.points * perPoint + samples;

  const double fields = 2.0 * study.scene.solver.memory + otherFields;
  const double run = std::max(cost.processBytes - programBytes, cost.matrixBytes + cost.factorBytes);
  // Configurations that are held out are runs with factors of their own.
  const double ofHoldOuts =
      plan.holdOuts > 0 ? cost.factorBytes + cost.singleBytes + cost.inverseBytes + cost.fieldBytes : 0.0;
  result.distributed =
      run + ofHoldOuts +
      entryBytes * steps * result.terms *
          (fields * static_cast<double>(cost.interfaceUnknowns) + 2.0 * static_cast<double>(cost.unknowns));
  // All polynomials are solved for at once.
  const double columns = steps * result.terms;
  perIteration += cost.exactSolves.seconds(columns) + columns * cost.columnSeconds;
  result.solveSeconds =
      result.points * secondsPerEntry * sizeOf(study.sceneTree.root) + result.iterations * perIteration +
      wholesOfSolution * cost.wholeSolves.seconds(columns) +
      result.terms * shareOfLeastSquares * cost.accelerationSeconds(result.iterations, study.scene.solver.memory);
  result.seconds = cost.factorSeconds + result.solveSeconds;
  return result;
}

ChaosChoice chooseLocalStage(const Study& study, const scene::Problem& problem, const Teuchos::Comm<int>& comm) {
  const ChaosOptions& options = *study.design.as<ChaosOptions>();
  const scene::CostEstimate cost =
      scene::estimateCost(problem, study.scene.solver, scene::FactorSizes::fromUnknowns, comm);
  const int ranks = comm.getSize();
  const ChaosCost spectral = estimateChaos(study, problem, cost, false);
  const ChaosCost galerkin = estimateChaos(study, problem, cost, true);
  if (options.localStage != ChaosOptions::LocalStage::automatic) {
    const ChaosCost& asked = options.wantsGalerkin() ? galerkin : spectral;
    return {asked, "as asked for: " + described(asked, ranks)};
  }
  if (!problem.assembly.isAffine()) {
    return {spectral, "because not all laws are affine: " + described(spectral, ranks)};
  }
  const std::string both =
      "Galerkin: " + described(galerkin, ranks) + "; pseudo-spectral: " + described(spectral, ranks);
  if (galerkin.points > mostTensorPoints) return {spectral, "because Galerkin has too many points. " + both};
  if (galerkin.bytesOf(ranks) > scene::memoryPerRank(comm)) {
    return {spectral, "because Galerkin needs more memory than is free. " + both};
  }
  if (galerkin.seconds > std::max(dearer * spectral.seconds, secondsThatCount)) {
    return {spectral, "because Galerkin is dearer. " + both};
  }
  return {galerkin, "because all laws are affine and it costs little more. " + both};
}

void demandMemory(const Study& study, const ChaosChoice& choice, const Teuchos::Comm<int>& comm) {
  const double free = scene::memoryPerRank(comm), wanted = choice.cost.bytesOf(comm.getSize());
  if (wanted <= free) return;
  std::ostringstream what;
  what << std::setprecision(2) << "the expansions take about " << wanted / 1e9 << " GB on every rank, of which "
       << free / 1e9 << " GB are free: " << std::fixed << std::setprecision(0) << choice.cost.terms << " polynomials, "
       << choice.cost.points << " points.";
  input::ErrorList errors;
  errors.add(study.design.where, what.str(),
             "Take Collocation with Points In set to Sparse, a lower Order, fewer Points, or more memory.");
  errors.throwIfAny();
}

}  // namespace harmos::study
