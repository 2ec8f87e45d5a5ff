#include <harmos/scene/CostEstimate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>
#include <vector>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/CorrectionSpace.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

namespace harmos::scene {
namespace {

constexpr double entryBytes = 8.0, singleEntryBytes = 4.0, matrixEntryBytes = 12.0;
// Entries of a factor: 25 n^(4/3) in space, 8 n log2 n in the plane.
constexpr double entriesInSpace = 25.0, growthInSpace = 4.0 / 3.0, entriesInPlane = 8.0;
// Of operations per unknown beside the square of the mean length of a column of the factor.
constexpr double unevenColumns = 1.5;
// Of a load step as most are: differences in its march, directions in its certificate, and fields of both stages.
constexpr int differences = 15, directions = 12, fields = 20;
constexpr int storedStates = latin::AndersonAcceleration::statesPerDifference * differences +
                             latin::CorrectionSpace::statesPerDirection * directions + fields;
// Of a process: the program with its libraries; how much of matrices, factors in both precisions and of what a column
// reads (traces are stored beside the factors) is there at the peak; of the stored states; displacement fields of all
// load steps, and what mesh, output and estimates keep for a node.
constexpr double programBytes = 61e6, matrixCopies = 5.9, factorCopies = 0.41, readCopies = 1.23, fieldShare = 0.8,
                 displacementFields = 6.9, bytesPerNode = 24.0;
// Seconds: of the program's start; of reading and assembling, per entry of the matrices; of factors, with traces and
// macro problem, per operation, per entry of the matrices and per unknown; of a linear stage, per entry that a column
// reads and, for all that is not a solve, per component of an interface side; of the error of the mesh, per unknown; of
// files, per unknown, and per unknown and load step.
constexpr double programSeconds = 0.11, assemblySeconds = 8e-8, operationSeconds = 1.9e-10, factoredEntrySeconds = 3e-7,
                 factoredUnknownSeconds = 1.5e-6, readEntrySeconds = 4.5e-10, interfaceSeconds = 1.3e-7,
                 recoverySecondsInSpace = 1.4e-5, recoverySecondsInPlane = 4.8e-6, fileSeconds = 1e-6,
                 stepFileSeconds = 1.2e-7;
// Linear stages at an accuracy of 1e-3, how many more a decade takes, and how they fall where there are more load steps
// than usual, which are shorter then.
constexpr double usualSteps = 11.0, growthWithSteps = -0.25;
constexpr double affineStages = 45.0, otherStages = 24.0, stagesPerDecade = 5.0, usualAccuracy = 1e-3;

// Numbers of entries are 32-bit integers; so many times what is estimated may be too large.
constexpr double mostEntries = 2147483647.0, uncertainty = 1.5;

substructure::FactorSize sizeOf(const substructure::Substructure& body, FactorSizes sizes) {
  if (sizes == FactorSizes::fromOrder) return substructure::SubstructureSolver::predict(*body.stiffness);
  const double n = static_cast<double>(body.nodes.size()) * body.dimension;
  substructure::FactorSize size;
  size.nonzeros =
      body.dimension == 3 ? entriesInSpace * std::pow(n, growthInSpace) : entriesInPlane * n * std::log2(n + 1.0);
  size.operations = unevenColumns * size.nonzeros * size.nonzeros / n;
  size.bytes = entryBytes * size.nonzeros;
  return size;
}

/// Unknowns of every body that interfaces touch, and boundaries that are not eliminated: those with affine laws, as a
/// rule.
std::vector<double> traces(const assembly::Assembly& assembly) {
  std::vector<std::set<int>> nodes(assembly.bodies.size());
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (interface.law->prescribesTraction()) continue;
    if (interface.sides() == 1 && interface.mass.empty() && interface.law->isAffine()) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      for (int p = 0; p < interface.pairs(); ++p) {
        for (const auto& [node, weight] : interface.trace(side).row(p)) nodes[interface.body(side)].insert(node);
      }
    }
  }
  std::vector<double> counts;
  for (const auto& one : nodes) counts.push_back(assembly.dimension * static_cast<double>(one.size()));
  return counts;
}

}  // namespace

CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, FactorSizes sizes,
                          const Teuchos::Comm<int>& comm) {
  enum Sum { matrixEntries, factorEntries, operations, readEntries, invertedEntries, sums };
  CostEstimate cost;
  const assembly::Assembly& assembly = problem.assembly;
  const double steps = assembly.steps();
  const std::vector<double> trace = traces(assembly);
  std::array<double, sums> mine{}, sum{};
  std::vector<substructure::FactorSize> known(assembly.bodies.size());
  const auto isDense = [&](std::size_t b, std::size_t master) {
    return trace[b] * trace[b] <= solver.stages.solver.denseTraceWorth() * known[master].nonzeros;
  };
  std::vector<bool> isCounted(assembly.bodies.size(), false);
  std::vector<double> mineOfBody(assembly.bodies.size(), 0.0), ofBody(assembly.bodies.size(), 0.0);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const substructure::Substructure& body = assembly.bodies[b];
    cost.unknowns += static_cast<std::int64_t>(body.nodes.size()) * assembly.dimension;
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    // Congruent bodies share a factor on every rank that has one of them.
    const std::size_t master = body.congruence ? static_cast<std::size_t>(body.congruence->representative) : b;
    if (!isCounted[master]) {
      isCounted[master] = true;
      const substructure::Substructure& factored = assembly.bodies[master];
      known[master] = sizeOf(factored, sizes);
      mine[matrixEntries] += static_cast<double>(factored.stiffness->getGlobalNumEntries());
      mine[factorEntries] += known[master].nonzeros;
      mineOfBody[master] = known[master].nonzeros;
      mine[operations] += known[master].operations;
      if (solver.stages.solver.invertTrace && isDense(b, master)) mine[invertedEntries] += trace[b] * trace[b];
    }
    // Each entry of a sparse factor is read twice, the triangle of a trace too.
    mine[readEntries] += isDense(b, master) ? trace[b] * trace[b] : 2.0 * known[master].nonzeros;
  }
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(sums), mine.data(), sum.data());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(ofBody.size()), mineOfBody.data(), ofBody.data());
  const auto largest = std::max_element(ofBody.begin(), ofBody.end());
  if (largest != ofBody.end()) {
    cost.largestFactor = *largest;
    cost.largestBody = assembly.bodies[largest - ofBody.begin()].name;
  }
  for (const auto& interface : assembly.interfaces)
    cost.interfaceUnknowns += static_cast<std::int64_t>(interface.pairs()) * interface.sides() * assembly.dimension;
  const double unknowns = static_cast<double>(cost.unknowns);
  const double interfaceUnknowns = static_cast<double>(cost.interfaceUnknowns);

  cost.steps = assembly.steps();
  const bool mayBeSingle = solver.stages.solver.allowsSingle && solver.algorithm == latin::Algorithm::accelerated &&
                           solver.stages.formulation == latin::Formulation::displacement;
  cost.matrixBytes = matrixEntryBytes * sum[matrixEntries];
  cost.factorBytes = entryBytes * sum[factorEntries];
  cost.singleBytes = mayBeSingle ? singleEntryBytes * sum[factorEntries] : 0.0;
  cost.inverseBytes = (entryBytes + singleEntryBytes) * sum[invertedEntries];
  cost.fieldBytes = entryBytes * storedStates * interfaceUnknowns * steps;
  cost.processBytes = programBytes * comm.getSize() + matrixCopies * cost.matrixBytes +
                      factorCopies * (cost.factorBytes + cost.singleBytes) +
                      readCopies * entryBytes * sum[readEntries] + cost.inverseBytes + fieldShare * cost.fieldBytes +
                      entryBytes * displacementFields * unknowns * steps + bytesPerNode * unknowns / assembly.dimension;

  cost.startSeconds = programSeconds * comm.getSize() + assemblySeconds * sum[matrixEntries];
  cost.factorSeconds = operationSeconds * sum[operations] + factoredEntrySeconds * sum[matrixEntries] +
                       factoredUnknownSeconds * unknowns;
  cost.stageSeconds = steps * (readEntrySeconds * sum[readEntries] + interfaceSeconds * interfaceUnknowns);
  const double decades = std::log10(usualAccuracy / solver.accuracy);
  cost.isAffine = assembly.isAffine();
  cost.stages = std::max(1.0, (cost.isAffine ? affineStages : otherStages) + stagesPerDecade * decades) *
                std::min(1.0, std::pow(steps / usualSteps, growthWithSteps));
  const double recoverySeconds = assembly.dimension == 3 ? recoverySecondsInSpace : recoverySecondsInPlane;
  cost.resultSeconds = unknowns * (recoverySeconds + fileSeconds + stepFileSeconds * steps);
  return cost;
}

void demandCapacity(const CostEstimate& cost, double freeBytes) {
  std::ostringstream message;
  if (cost.largestFactor > mostEntries) {
    message << "part \"" << cost.largestBody << "\": its factor would have " << std::setprecision(2)
            << cost.largestFactor << " entries, more than direct solvers can number (" << mostEntries
            << ").\n  Cut it: add <Parameter name=\"Pieces\" type=\"int\" value=\"" << std::setprecision(0)
            << std::fixed << std::ceil(2.0 * std::pow(cost.largestFactor / mostEntries, 0.75)) << "\"/> to the part.";
    throw base::Error(message.str(), base::ExitCode::input);
  }
  if (cost.processBytes <= uncertainty * freeBytes) return;
  message
      << "a run takes about " << std::setprecision(2) << cost.processBytes / 1e9 << " GB, of which " << freeBytes / 1e9
      << " GB are free.\n  Cut large parts (Pieces), take a coarser mesh or fewer load steps, or more ranks on other "
         "machines.";
  throw base::Error(message.str(), base::ExitCode::input);
}

}  // namespace harmos::scene
