#include <harmos/scene/CostEstimate.hpp>

#include <cmath>
#include <vector>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/latin/AndersonAcceleration.hpp>
#include <harmos/latin/CorrectionSpace.hpp>

namespace harmos::scene {

CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, const Teuchos::Comm<int>& comm) {
  constexpr double entryBytes = 8.0, singleEntryBytes = 4.0, matrixEntryBytes = 12.0;
  // Entries of a factor: 25 n^(4/3) in space, 8 n log2 n in the plane.
  constexpr double entriesInSpace = 25.0, growthInSpace = 4.0 / 3.0, entriesInPlane = 8.0;
  // Of a factorisation: measured with so many unknowns, and how it grows with them.
  constexpr double measuredSeconds = 0.8, measuredUnknowns = 24000.0, growthOfSeconds = 1.7;
  // Of a load step as most are: differences in its march, directions in its certificate, and fields of both stages.
  constexpr int differences = 15, directions = 12, fields = 20;
  constexpr int storedStates = latin::AndersonAcceleration::statesPerDifference * differences +
                               latin::CorrectionSpace::statesPerDirection * directions + fields;
  // Of a process: the program with its libraries; how much of matrices and factors is there more than once while they
  // are made; displacement fields of all load steps, and what mesh, output and estimates keep for a node.
  constexpr double programBytes = 58e6, matrixCopies = 3.5, factorCopies = 1.3, displacementFields = 8.0,
                   bytesPerNode = 500.0;
  constexpr double secondsPerEntryAndColumn = 2.4e-10;  // forward and backward substitution of several columns
  CostEstimate cost;
  const assembly::Assembly& assembly = problem.assembly;
  const bool mayBeSingle = solver.stages.solver.allowsSingle && solver.algorithm == latin::Algorithm::accelerated &&
                           solver.stages.formulation == latin::Formulation::displacement;
  double matrixEntries = 0.0, factorEntries = 0.0, singleEntries = 0.0;
  for (const auto& body : assembly.bodies) {
    const double n = static_cast<double>(body.nodes.size()) * assembly.dimension;
    cost.unknowns += static_cast<std::int64_t>(n);
    if (body.stiffness.is_null()) continue;
    matrixEntries += static_cast<double>(body.stiffness->getGlobalNumEntries());
    const double entries =
        assembly.dimension == 3 ? entriesInSpace * std::pow(n, growthInSpace) : entriesInPlane * n * std::log2(n + 1.0);
    factorEntries += entries;
    if (mayBeSingle) singleEntries += entries;
    cost.factorSeconds += measuredSeconds * std::pow(n / measuredUnknowns, growthOfSeconds);
  }
  std::vector<double> mine{matrixEntries, factorEntries, cost.factorSeconds, singleEntries}, sum(4);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, 4, mine.data(), sum.data());
  for (const auto& interface : assembly.interfaces)
    cost.interfaceUnknowns += static_cast<std::int64_t>(interface.pairs()) * interface.sides() * assembly.dimension;
  cost.matrixBytes = matrixEntryBytes * sum[0];
  cost.factorBytes = entryBytes * sum[1];
  cost.factorSeconds = sum[2];
  cost.singleBytes = singleEntryBytes * sum[3];
  cost.fieldBytes = entryBytes * storedStates * static_cast<double>(cost.interfaceUnknowns) * assembly.steps();
  const double unknowns = static_cast<double>(cost.unknowns);
  cost.processBytes = programBytes * comm.getSize() + matrixCopies * cost.matrixBytes +
                      factorCopies * cost.factorBytes + cost.singleBytes + cost.fieldBytes +
                      entryBytes * displacementFields * unknowns * assembly.steps() +
                      bytesPerNode * unknowns / assembly.dimension;
  cost.stageSeconds = secondsPerEntryAndColumn * sum[1] * assembly.steps();
  return cost;
}

}  // namespace harmos::scene
