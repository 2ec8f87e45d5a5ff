#include <harmos/scene/detail/CostModel.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/StencilWorth.hpp>
#include <harmos/latin/StepsAtOnce.hpp>
#include <harmos/scene/detail/ExpectedStages.hpp>

namespace harmos::scene {
namespace {

constexpr double entryBytes = 8.0, singleEntryBytes = 4.0, matrixEntryBytes = 12.0;
// Entries of a factor: 25 n^(4/3) in space, 8 n log2 n in the plane.
constexpr double entriesInSpace = 25.0, growthInSpace = 4.0 / 3.0, entriesInPlane = 8.0;
// Of operations per unknown beside the square of the mean length of a column of the factor.
constexpr double unevenColumns = 1.5;
// Fields of a load step beside those: the state, its image and where they began, the residual, and what both stages and
// estimates are made of.
constexpr double fields = 6.5;
// Of a process: the program with its libraries; matrices with what they are assembled and ordered from; factors that
// columns go through, in double and in single precision; factors of bodies that nothing iterates on, with the padding
// of their supernodes; what the macro problem multiplies tractions with; of the differences of a march what is still
// there when a certificate has all its directions; displacement fields of the load steps that are looked at together,
// and of the others; and what mesh, output and estimates keep for an unknown.
constexpr double programBytes = 60e6, matrixCopies = 4.4, paddedFactor = 1.3, reactionCopies = 5.5,
                 differencesLeft = 0.5, fieldsAtOnce = 1.4, fieldsOfOthers = 0.4, bytesPerUnknown = 90.0;
// Seconds: of the program's start; of reading and assembling, per entry of the matrices of all bodies; of factors per
// operation, per entry, per entry that columns of the macro problem read, per entry of the matrices and, for the order,
// per unknown. Of a linear stage and load step: per entry that a column reads, per component of an interface side for
// all that is not a solve, per body and per interface side for the calls, however small these are, and per entry of
// what the macro problem multiplies one column with. Of least squares, per component of an interface side, load step
// and pair of directions of the certificate, or of differences of a march. Of how tractions may be shared, per group of
// nodes and load step; of files, per unknown, and per unknown and load step. Of what tractions can share around rings
// of interfaces, per ring; of loads, per loaded unknown and load step; of a product with a stiffness, per entry and
// column. Of responses, per load step: for each node and for each pair that they read, and for each node at which
// stress is recovered, there once more for every window of load steps that is looked at together.
constexpr double programSeconds = 0.08, assemblySeconds = 5e-8, operationSeconds = 4.5e-11, factorEntrySeconds = 1.5e-8,
                 macroReadSeconds = 1.5e-10, factoredEntrySeconds = 2.5e-8, factoredUnknownSeconds = 5.5e-6,
                 readEntrySeconds = 2.2e-10, interfaceSeconds = 3e-8, bodySeconds = 1e-6, sideSeconds = 7e-7,
                 reactionSeconds = 7e-10, correctionSeconds = 5e-9, differenceSeconds = 4e-9,
                 sharedNodeSeconds[] = {1e-4, 5e-4}, fileSeconds = 1e-6, stepFileSeconds = 1.8e-7, ringSeconds = 5e-4,
                 loadSeconds = 4e-8, productSeconds = 1e-9, nodeSeconds = 6e-8, pairSeconds = 2.2e-8,
                 recoveredSeconds = 3e-7, recoverySeconds = 5.5e-6;
// Of the error of the mesh in a linear response, per unknown: seconds and bytes; linear stages of its adjoint field, at
// one load step in double precision.
constexpr double errorSeconds = 1.5e-7, errorBytes = 35.0, stagesOfAdjoint = 6.0;
// Digits of a march to which solves in single precision are exact enough.
constexpr double digitsOfSingle = 4.0;
// Of the iterations of a march at a load step: what share looks at reactions, every eighth for the size of forces and
// every ninth for their balance.
constexpr double looksOfMarch = 1.0 / 8.0 + 1.0 / 9.0;
// Of the recovery of stress for the error of the mesh, per node: around those of quadratic tetrahedra too few elements
// are found, and their neighbours are taken besides.
constexpr double recoveryInPlane = 4.5e-6, recoveryOfLinear = 1.15e-5, recoveryOfQuadratic = 1.8e-5,
                 recoveryOfTet10 = 6e-5;
// Bytes of a node and load step while stress is recovered: samples in its elements, and what is made of them; of an
// element and load step of those that are written together.
constexpr double recoveredBytes = 300.0, writtenBytes = 60.0;
// Of operators that are solved iteratively: bytes per entry at the peak, with the preconditioner; iterations of a
// column; seconds per entry of the preconditioner and of an iteration; entries of a row of small elements.
constexpr double iteratedEntryBytes = 35.0, iterationsOfColumn = 15.0, multigridSeconds = 1.6e-7,
                 iterationSeconds = 6e-9, entriesOfRow[] = {18.0, 75.0};
// Of derivatives, which are solved for to 1e-9: how directions grow with the parameters, which share them, and how many
// of earlier load steps are kept. States that are kept for each of them, and for each parameter and load step; what
// solving for one takes over its share of a linear stage; and seconds of what makes them orthogonal, per component of
// an interface side and pair of directions.
constexpr double growthWithParameters = 0.6, mostOfEarlierSteps = 60.0, statesOfDirection = 3.3,
                 statesOfDerivative = 2.0, stagesOfDirection = 1.4, directionSeconds = 3e-9;
// Columns of the macro problem for an interface of a body, in the plane and in space: its motions as a rigid body.
constexpr double motionsOfInterface[] = {3.0, 6.0};
// Solvers without supernodes beside CHOLMOD and Tacho: bytes of an entry, of both triangles with their rows, and how
// much longer factors and solves take.
constexpr double plainEntryBytes = 24.0, plainSlowness = 18.0;

/// States of all load steps together that an iteration keeps.
double storedStates(double steps, const ExpectedStages& stages, double memory) {
  constexpr double most = latin::stepsAtOnce;
  const double remembered = steps > most ? 1.0 : steps;
  return differencesLeft * latin::AndersonAcceleration::statesPerDifference * std::min(stages.march, memory) *
             remembered +
         latin::CorrectionSpace::statesPerDirection * stages.certificate * std::min(steps, most) + fields * steps;
}

}  // namespace

double recoverySecondsOf(mesh::ElementType type) {
  if (mesh::dimensionOf(type) == 2) return recoveryInPlane;
  if (!mesh::isQuadratic(type)) return recoveryOfLinear;
  return mesh::linearType(type) == mesh::ElementType::tet4 ? recoveryOfTet10 : recoveryOfQuadratic;
}

substructure::FactorSize factorOf(double unknowns, int dimension) {
  substructure::FactorSize size;
  size.nonzeros = dimension == 3 ? entriesInSpace * std::pow(unknowns, growthInSpace)
                                 : entriesInPlane * unknowns * std::log2(unknowns + 1.0);
  size.operations = unevenColumns * size.nonzeros * size.nonzeros / unknowns;
  size.bytes = entryBytes * size.nonzeros;
  return size;
}

double leastBytes(double entries) {
  return (matrixEntryBytes + iteratedEntryBytes) * entries;
}

double operatorEntries(double unknowns, int dimension) {
  return entriesOfRow[dimension - 2] * unknowns;
}

void CostEstimate::addDerivatives(int parameters) {
  if (parameters == 0) return;
  const double rows = static_cast<double>(interfaceUnknowns);
  const double ofStep = directionsOfStep * std::pow(parameters, growthWithParameters), directions = ofStep * steps;
  const double kept = ofStep + std::min(directions - ofStep, mostOfEarlierSteps);
  derivativeBytes = entryBytes * rows * (statesOfDirection * kept + statesOfDerivative * parameters * steps);
  processBytes += derivativeBytes;
  derivativeSeconds = directions * (stagesOfDirection * (exactSolves.seconds(parameters) / parameters + columnSeconds) +
                                    0.5 * directionSeconds * rows * kept);
}

double CostEstimate::accelerationSeconds(double iterations, double memory) const {
  return differenceSeconds * steps * static_cast<double>(interfaceUnknowns) * iterations * std::min(iterations, memory);
}

void CostSums::add(const BodySize& body, const latin::LatinOptions& solver) {
  const substructure::SolverOptions& options = solver.stages.solver;
  const double square = body.trace * body.trace / body.factor.blocks, entries = body.factor.nonzeros;
  const double rows = body.trace / body.factor.blocks, entriesOfBlock = entries / body.factor.blocks;
  const bool isDense = body.factor.isTraceLast || options.keepsDense(rows, entriesOfBlock);
  const bool isInverted =
      body.factor.isTraceLast ? body.factor.isTraceInverted : isDense && options.inverts(rows, entriesOfBlock);
  const bool hasStencil = isDense && latin::isStencilWorthwhile(options, body.held, body.trace);
  const auto addSolve = [&](SolveSums::Kind kind, double met) {
    solves_.add(kind, met, body.unknowns, body.isFactored);
  };
  if (body.isLoaded) {
    // Displacements that loads make by themselves are kept where columns are solved on the trace alone.
    sum_[loadFields] += (isDense ? 2.0 : 1.0) * body.unknowns;
    addSolve(SolveSums::loaded, entries);
    sum_[loadedUnknowns] += body.unknowns;
  }
  if (body.isMoved) {
    // Where they hold it, what that loads it with, and what it makes of it.
    sum_[loadFields] += (isDense ? 4.0 : 3.0) * body.unknowns;
    sum_[movedReads] += 2.0 * entries;
    sum_[movedEntries] += body.matrixEntries;
  }
  if (body.isLoaded) sum_[loadedReads] += 2.0 * entries;
  if (hasStencil) sum_[stencilLooks] += body.held * body.trace;
  if (body.isAssembled) sum_[body.iteratedEntries > 0.0 ? iteratedMatrix : matrixEntries] += body.matrixEntries;
  sum_[assembledEntries] += body.matrixEntries;
  sum_[reactions] += body.trace * body.interfaces;
  if (body.iteratedEntries > 0.0) {
    sum_[readIterated] += body.iteratedEntries;
    if (body.isFactored) sum_[storedIterated] += body.iteratedEntries;
    if (body.isFactored && body.trace > 0.0) sum_[macroIterated] += body.interfaces * body.iteratedEntries;
    return;
  }
  if (body.isFactored) {
    sum_[factoredEntries] += body.matrixEntries;
    sum_[factoredUnknowns] += body.unknowns;
    sum_[factorEntries] += entries;
    if (body.trace == 0.0) sum_[looseEntries] += entries;
    // A trace that is kept dense is eliminated last.
    const bool isCounted = !isDense || body.factor.isTraceLast;
    sum_[operations] += body.factor.operations + (isCounted ? 0.0 : square * body.trace / body.factor.blocks / 3.0);
    sum_[factored] += 1.0;
    if (isDense) sum_[dense] += 1.0;
    if (isInverted) {
      sum_[inverted] += 1.0;
      sum_[invertedEntries] += square / 2.0;  // of a triangle
      sum_[inverseOperations] += 2.0 / 3.0 * square * rows;
    }
    if (hasStencil) {
      sum_[stencilReads] += 2.0 * body.held * entries;
      sum_[stencilEntries] += body.held * body.trace;
    }
    if (body.trace > 0.0) sum_[macroReads] += 2.0 * body.interfaces * entries;
  }
  const bool isHeld = body.held > 0.0 && !hasStencil;
  if (isDense) addSolve(isInverted ? SolveSums::inverses : SolveSums::traces, isInverted ? square / 2.0 : square);
  addSolve(SolveSums::whole, entries);
  addSolve(isDense ? SolveSums::dense : SolveSums::sparse, entries);
  if (isDense && (body.isLoaded || isHeld)) addSolve(SolveSums::looked, entries);
  if (isHeld) addSolve(isDense ? SolveSums::held : SolveSums::heldSparse, entries);
}

void CostSums::reduce(const Teuchos::Comm<int>& comm) {
  std::array<double, sums> all{};
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(sums), sum_.data(), all.data());
  sum_ = all;
  solves_.reduce(comm);
}

CostEstimate CostSums::estimate(const CostScope& scope, const latin::LatinOptions& solver) const {
  CostEstimate cost;
  const double steps = scope.steps, together = std::min<double>(steps, latin::stepsAtOnce);
  cost.unknowns = static_cast<std::int64_t>(scope.unknowns);
  cost.interfaceUnknowns = static_cast<std::int64_t>(scope.interfaceUnknowns);
  cost.steps = scope.steps;
  cost.isAffine = scope.isAffine;
  const double motions = motionsOfInterface[scope.dimension - 2];
  const bool isDirect = sum_[looseEntries] == sum_[factorEntries] && sum_[macroIterated] == 0.0;
  const ExpectedStages stages = isDirect ? ExpectedStages() : expectedStages(scope, solver);
  const bool isStepwise = solver.algorithm == latin::Algorithm::accelerated &&
                          solver.stages.formulation == latin::Formulation::displacement;
  const bool mayBeSingle = isStepwise && solver.stages.solver.allowsSingle && solver.stages.solver.hasSupernodes();
  const double iterated = sum_[factorEntries] - sum_[looseEntries];  // entries of factors that columns go through
  cost.matrixBytes = matrixEntryBytes * (sum_[matrixEntries] + sum_[iteratedMatrix]);
  const bool isPlain = !solver.stages.solver.hasSupernodes();
  const double slowness = isPlain ? plainSlowness : 1.0;
  const auto ofBodies = [&](SolveSums::Kind kind) { return slowness * solves_.ofBodies(kind); };
  const substructure::FactorSize macro = factorOf(motions * scope.sides / 2.0 + 1.0, scope.dimension);
  cost.factorBytes = (isPlain ? plainEntryBytes : entryBytes) * sum_[factorEntries];
  cost.singleBytes = mayBeSingle ? singleEntryBytes * iterated : 0.0;
  cost.iteratedBytes = iteratedEntryBytes * sum_[storedIterated];
  cost.inverseBytes = (entryBytes + singleEntryBytes) * sum_[invertedEntries];
  cost.stencilBytes = entryBytes * sum_[stencilEntries];
  cost.factored = static_cast<int>(sum_[factored]);
  cost.dense = static_cast<int>(sum_[dense]);
  cost.inverted = static_cast<int>(sum_[inverted]);
  cost.fieldBytes = entryBytes * storedStates(steps, stages, solver.memory) * scope.interfaceUnknowns;
  cost.processBytes =
      programBytes * scope.ranks + matrixEntryBytes * (matrixCopies * sum_[matrixEntries] + sum_[iteratedMatrix]) +
      cost.factorBytes + cost.singleBytes + (paddedFactor - 1.0) * entryBytes * sum_[looseEntries] +
      cost.iteratedBytes + entryBytes * (macro.nonzeros + steps * sum_[loadFields]) + cost.inverseBytes +
      cost.stencilBytes + reactionCopies * entryBytes * motions * sum_[reactions] + cost.fieldBytes +
      entryBytes * scope.unknowns * (fieldsAtOnce * together + fieldsOfOthers * (steps - together)) +
      recoveredBytes * scope.work.together * together + bytesPerUnknown * scope.unknowns;

  cost.startSeconds = programSeconds * scope.ranks + assemblySeconds * sum_[assembledEntries];
  // As when they are factored, but for the graph of their nodes.
  cost.cuttingSeconds =
      scope.ranks * scope.measured *
      (factoredUnknownSeconds + factoredEntrySeconds * operatorEntries(scope.dimension, scope.dimension));
  const double rings = std::max(0.0, scope.sides / 2.0 - scope.bodies);
  cost.factorSeconds = slowness * (operationSeconds * sum_[operations] + factorEntrySeconds * sum_[factorEntries] +
                                   macroReadSeconds * motions * sum_[macroReads]) +
                       ofBodies(SolveSums::loaded).seconds(steps) + operationSeconds * macro.operations +
                       ringSeconds * rings + steps * loadSeconds * sum_[loadedUnknowns] +
                       factoredEntrySeconds * sum_[factoredEntries] + factoredUnknownSeconds * sum_[factoredUnknowns] +
                       multigridSeconds * sum_[storedIterated] +
                       iterationSeconds * iterationsOfColumn * motions * sum_[macroIterated];
  cost.factorSeconds +=
      operationSeconds * sum_[inverseOperations] + latin::shareOfSolveAmongMany * readEntrySeconds * sum_[stencilReads];
  cost.wholeSolves = ofBodies(SolveSums::whole);
  cost.lookSeconds = ofBodies(scope.work.recovered > 0.0 ? SolveSums::dense : SolveSums::looked).seconds(steps);
  cost.staticsSeconds =
      scope.statics.seconds(steps) + sharedNodeSeconds[scope.dimension - 2] * scope.joints.sharedNodes * steps;
  // A march goes on with one load step at a time, in single precision as long as its residuals allow it.
  const SolveSeconds ofTraces = solves_.ofDenseTraces();
  cost.exactSolves = ofBodies(SolveSums::sparse) + ofTraces;
  const double single =
      mayBeSingle && !scope.softens ? std::min(1.0, digitsOfSingle / std::log10(1.0 / solver.accuracy)) : 0.0;
  const SolveSeconds ofMarch =
      single * (solves_.ofTracesInSingle(SolveSums::sparse) + ofTraces) + (1.0 - single) * cost.exactSolves;
  cost.readSeconds = isStepwise ? steps * ofMarch.seconds(1.0) : ofMarch.seconds(steps);
  cost.columnSeconds = 2.0 * readEntrySeconds * macro.nonzeros + reactionSeconds * motions * sum_[reactions] +
                       interfaceSeconds * scope.interfaceUnknowns + bodySeconds * scope.bodies +
                       sideSeconds * scope.sides + iterationSeconds * iterationsOfColumn * sum_[readIterated];
  const SolveSeconds look = ofBodies(SolveSums::held) + single * solves_.ofBodiesInSingle(SolveSums::heldSparse);
  cost.stageSeconds = cost.readSeconds + steps * (cost.columnSeconds + looksOfMarch * look.seconds(1.0));
  cost.stages = stages.all();
  cost.otherStages = stages.others;
  cost.certificateStages = stages.certificate;
  cost.togetherSeconds = ofMarch.seconds(steps) + steps * cost.columnSeconds;
  cost.directionsOfStep = stages.directions;
  // What loads do by themselves is solved for, twice where boundaries move a body, since the macro problem asks, too.
  cost.loadSeconds = steps * (slowness * latin::shareOfSolveAmongMany * readEntrySeconds *
                                  (sum_[loadedReads] + 2.0 * sum_[movedReads]) +
                              productSeconds * sum_[movedEntries] + loadSeconds * sum_[loadedUnknowns]);
  cost.boundarySeconds = steps * (2.0 * nodeSeconds * scope.boundaryPairs + operationSeconds * sum_[stencilLooks]);
  cost.responses = scope.responses;
  cost.responseSeconds = steps * (nodeSeconds * scope.work.nodes + pairSeconds * scope.work.pairs +
                                  recoveredSeconds * scope.work.recovered) +
                         std::ceil(steps / latin::stepsAtOnce) * recoverySeconds * scope.work.recovered;
  cost.wholeSeconds = cost.wholeSolves.seconds(steps);
  cost.correctionSeconds =
      steps * scope.interfaceUnknowns * correctionSeconds * stages.certificate * stages.certificate +
      cost.accelerationSeconds(stages.march, solver.memory) +
      ExpectedStages::ways * cost.accelerationSeconds(stages.others / ExpectedStages::ways, solver.memory);
  const double adjoint =
      stagesOfAdjoint * (cost.exactSolves.seconds(1.0) + cost.columnSeconds) + cost.wholeSolves.seconds(1.0);
  cost.meshErrorSeconds = scope.recoverySeconds + scope.linearResponses * (errorSeconds * scope.unknowns + adjoint);
  cost.meshErrorBytes = errorBytes * scope.unknowns * scope.linearResponses;
  cost.fileBytes = writtenBytes * scope.elements * together;
  cost.fileSeconds = scope.unknowns * (fileSeconds + stepFileSeconds * steps);
  return cost;
}

}  // namespace harmos::scene
