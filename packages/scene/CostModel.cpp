#include <harmos/scene/detail/CostModel.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <Teuchos_CommHelpers.hpp>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/latin/StepsAtOnce.hpp>

namespace harmos::scene {
namespace {

constexpr double entryBytes = 8.0, singleEntryBytes = 4.0, matrixEntryBytes = 12.0;
// Entries of a factor: 25 n^(4/3) in space, 8 n log2 n in the plane.
constexpr double entriesInSpace = 25.0, growthInSpace = 4.0 / 3.0, entriesInPlane = 8.0;
// Of operations per unknown beside the square of the mean length of a column of the factor.
constexpr double unevenColumns = 1.5;
// Of a load step as most are: differences in its march, directions in its certificate, and fields of both stages.
constexpr int differences = 15, directions = 12, fields = 18;
// Of a process: the program with its libraries; how much of matrices, factors in both precisions and of what a column
// reads (traces are stored beside the factors) is there at the peak; of factors of bodies that nothing iterates on,
// with the padding of their supernodes; of the stored states; displacement fields of the load steps that are looked at
// together, and of the others; and what mesh, output and estimates keep for a node.
constexpr double programBytes = 61e6, matrixCopies = 5.9, factorCopies = 0.41, readCopies = 1.23, paddedFactor = 1.3,
                 fieldShare = 0.6, fieldsAtOnce = 4.5, fieldsOfOthers = 0.4, bytesPerNode = 24.0;
// Seconds: of the program's start; of reading and assembling, per entry of the matrices; of factors per operation, per
// entry, per entry that columns of the macro problem read, per entry of the matrices and per unknown; of a linear
// stage, per entry that a column reads and, for all that is not a solve, per component of an interface side; of the
// error of the mesh, per unknown; of files, per unknown, and per unknown and load step.
constexpr double programSeconds = 0.09, assemblySeconds = 8e-8, operationSeconds = 4.5e-11, factorEntrySeconds = 1.5e-8,
                 macroReadSeconds = 1.5e-10, factoredEntrySeconds = 2e-7, factoredUnknownSeconds = 1.5e-6,
                 readEntrySeconds = 2.6e-10, interfaceSeconds = 1e-7, recoverySecondsInSpace = 9e-6,
                 recoverySecondsInPlane = 3e-6, fileSeconds = 1e-6, stepFileSeconds = 1.1e-7;
// Of operators that are solved iteratively: bytes per entry at the peak, with the preconditioner; iterations of a
// column; seconds per entry of the preconditioner and of an iteration; entries of a row of small elements.
constexpr double iteratedEntryBytes = 35.0, iterationsOfColumn = 15.0, multigridSeconds = 1.6e-7,
                 iterationSeconds = 6e-9, entriesOfRow[] = {18.0, 75.0};
// Columns of the macro problem for an interface of a body: its motions.
constexpr double motionsOfInterface = 6.0;
// Linear stages at an accuracy of 1e-3, how many more a decade takes, and how they fall where there are more load steps
// than usual, which are shorter then.
constexpr double usualSteps = 11.0, growthWithSteps = -0.25;
constexpr double affineStages = 45.0, otherStages = 24.0, stagesPerDecade = 5.0, usualAccuracy = 1e-3;
// Of the stages: for every doubling of the pieces of a part. Stages where nothing is left to iterate on.
constexpr double growthWithPieces = 0.18, directStages = 4.0;

/// States of all load steps together that an iteration keeps.
double storedStates(double steps) {
  constexpr double most = latin::stepsAtOnce;
  const double remembered = steps > most ? 1.0 : steps;
  return latin::AndersonAcceleration::statesPerDifference * differences * remembered +
         latin::CorrectionSpace::statesPerDirection * directions * std::min(steps, most) + fields * steps;
}

/// Whether a boundary stands in the operator of its body, as a rule.
bool isEliminated(const assembly::Interface& interface) {
  return interface.sides() == 1 && interface.mass.empty() && interface.law->isAffine() &&
         !interface.law->prescribesTraction();
}

/// Unknowns of a body, ascending, that some interfaces touch.
template <class IsOne>
std::vector<int> unknownsAt(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension,
                            const IsOne& isOne) {
  std::set<int> nodes;
  for (const assembly::Interface& interface : interfaces) {
    if (!isOne(interface)) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) != static_cast<int>(body)) continue;
      for (int p = 0; p < interface.pairs(); ++p) {
        for (const auto& [node, weight] : interface.trace(side).row(p)) nodes.insert(node);
      }
    }
  }
  std::vector<int> unknowns;
  for (const int node : nodes) {
    for (int c = 0; c < dimension; ++c) unknowns.push_back(node * dimension + c);
  }
  return unknowns;
}

}  // namespace

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

std::vector<int> traceOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension) {
  return unknownsAt(interfaces, body, dimension, [](const assembly::Interface& interface) {
    return !interface.law->prescribesTraction() && !isEliminated(interface);
  });
}

std::vector<int> heldOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension) {
  return unknownsAt(interfaces, body, dimension, isEliminated);
}

substructure::BoundaryTerm boundaryOf(const std::vector<assembly::Interface>& interfaces, std::size_t body,
                                      int dimension, std::size_t nodes) {
  substructure::BoundaryTerm term;
  term.dimension = dimension;
  term.diagonal.assign(nodes * static_cast<std::size_t>(dimension), 0.0);
  std::map<std::pair<int, int>, double> pairs;
  for (const assembly::Interface& interface : interfaces) {
    if (interface.law->prescribesTraction() || isEliminated(interface)) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      const mesh::TraceOperator& trace = interface.trace(side);
      if (interface.body(side) != static_cast<int>(body)) continue;
      const auto add = [&](int p, int q, double value) {
        for (const auto& [row, rowWeight] : trace.row(p)) {
          for (const auto& [column, columnWeight] : trace.row(q))
            pairs[{row, column}] += rowWeight * columnWeight * value;
        }
      };
      for (const mesh::MassEntry& entry : interface.mass) add(entry.row, entry.column, entry.value);
      for (int p = 0; p < interface.pairs() && interface.mass.empty(); ++p) {
        if (!trace.isSelection()) {
          add(p, p, interface.area[p]);
          continue;
        }
        for (int c = 0; c < dimension; ++c) term.diagonal[trace.node(p) * dimension + c] += interface.area[p];
      }
    }
  }
  for (const auto& [place, value] : pairs) term.entries.push_back({place.first, place.second, value});
  for (const int row : heldOf(interfaces, body, dimension)) {
    if (row % dimension == 0) term.free.push_back({row / dimension, {}});
  }
  return term;
}

std::vector<double> interfacesOf(const std::vector<assembly::Interface>& interfaces, std::size_t bodies) {
  std::vector<double> counts(bodies, 0.0);
  for (const assembly::Interface& interface : interfaces) {
    for (int side = 0; side < interface.sides(); ++side) counts[interface.body(side)] += 1.0;
  }
  return counts;
}

void CostSums::add(const BodySize& body, const latin::LatinOptions& solver) {
  const double square = body.trace * body.trace / body.factor.blocks, entries = body.factor.nonzeros;
  const bool isDense = body.trace > 0.0 && square <= solver.stages.solver.denseTraceWorth() * entries;
  sum_[body.iteratedEntries > 0.0 ? iteratedMatrix : matrixEntries] += body.matrixEntries;
  if (body.iteratedEntries > 0.0) {
    sum_[readIterated] += body.iteratedEntries;
    if (body.isFactored) sum_[storedIterated] += body.iteratedEntries;
    if (body.isFactored && body.trace > 0.0)
      sum_[macroIterated] += motionsOfInterface * body.interfaces * body.iteratedEntries;
    return;
  }
  if (body.isFactored) {
    sum_[factorEntries] += entries;
    if (body.trace == 0.0) sum_[looseEntries] += entries;
    // A trace that is kept dense is eliminated last.
    sum_[operations] += body.factor.operations + (isDense ? square * body.trace / body.factor.blocks / 3.0 : 0.0);
    if (solver.stages.solver.invertTrace && isDense) sum_[invertedEntries] += square / 2.0;  // of a triangle
    if (body.trace > 0.0) sum_[macroReads] += 2.0 * motionsOfInterface * body.interfaces * entries;
  }
  // Each entry of a sparse factor is read twice, the triangle of a trace too.
  const double read = isDense ? square : 2.0 * entries;
  sum_[readEntries] += read;
  if (body.isFactored) sum_[storedEntries] += read;
}

void CostSums::reduce(const Teuchos::Comm<int>& comm) {
  std::array<double, sums> all{};
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(sums), sum_.data(), all.data());
  sum_ = all;
}

CostEstimate CostSums::estimate(const CostScope& scope, const latin::LatinOptions& solver) const {
  CostEstimate cost;
  const double steps = scope.steps, together = std::min<double>(steps, latin::stepsAtOnce);
  cost.unknowns = static_cast<std::int64_t>(scope.unknowns);
  cost.interfaceUnknowns = static_cast<std::int64_t>(scope.interfaceUnknowns);
  cost.steps = scope.steps;
  const bool mayBeSingle = solver.stages.solver.allowsSingle && solver.algorithm == latin::Algorithm::accelerated &&
                           solver.stages.formulation == latin::Formulation::displacement;
  const double iterated = sum_[factorEntries] - sum_[looseEntries];  // entries of factors that columns go through
  cost.matrixBytes = matrixEntryBytes * (sum_[matrixEntries] + sum_[iteratedMatrix]);
  cost.factorBytes = entryBytes * sum_[factorEntries];
  cost.singleBytes = mayBeSingle ? singleEntryBytes * iterated : 0.0;
  cost.iteratedBytes = iteratedEntryBytes * sum_[storedIterated];
  cost.inverseBytes = (entryBytes + singleEntryBytes) * sum_[invertedEntries];
  cost.fieldBytes = entryBytes * storedStates(steps) * scope.interfaceUnknowns;
  cost.processBytes = programBytes * scope.ranks +
                      matrixEntryBytes * (matrixCopies * sum_[matrixEntries] + sum_[iteratedMatrix]) +
                      factorCopies * (entryBytes * iterated + cost.singleBytes) +
                      readCopies * entryBytes * (sum_[storedEntries] - 2.0 * sum_[looseEntries]) +
                      paddedFactor * entryBytes * sum_[looseEntries] + cost.iteratedBytes + cost.inverseBytes +
                      fieldShare * cost.fieldBytes +
                      entryBytes * scope.unknowns * (fieldsAtOnce * together + fieldsOfOthers * (steps - together)) +
                      bytesPerNode * scope.unknowns / scope.dimension;

  cost.startSeconds = programSeconds * scope.ranks + assemblySeconds * (sum_[matrixEntries] + sum_[iteratedMatrix]);
  cost.factorSeconds = operationSeconds * sum_[operations] + factorEntrySeconds * sum_[factorEntries] +
                       macroReadSeconds * sum_[macroReads] + factoredEntrySeconds * sum_[matrixEntries] +
                       factoredUnknownSeconds * scope.unknowns + multigridSeconds * sum_[storedIterated] +
                       iterationSeconds * iterationsOfColumn * sum_[macroIterated];
  cost.stageSeconds = steps * (readEntrySeconds * sum_[readEntries] + interfaceSeconds * scope.interfaceUnknowns +
                               iterationSeconds * iterationsOfColumn * sum_[readIterated]);
  const double decades = std::log10(usualAccuracy / solver.accuracy);
  cost.isAffine = scope.isAffine;
  const double usual = scope.isAffine ? affineStages : otherStages * (1.0 + growthWithPieces * std::log2(scope.pieces));
  cost.stages = sum_[looseEntries] == sum_[factorEntries] && sum_[macroIterated] == 0.0
                    ? directStages
                    : std::max(1.0, usual + stagesPerDecade * decades) *
                          std::min(1.0, std::pow(steps / usualSteps, growthWithSteps));
  const double recoverySeconds = scope.dimension == 3 ? recoverySecondsInSpace : recoverySecondsInPlane;
  cost.resultSeconds = scope.unknowns * (recoverySeconds + fileSeconds + stepFileSeconds * steps);
  return cost;
}

}  // namespace harmos::scene
