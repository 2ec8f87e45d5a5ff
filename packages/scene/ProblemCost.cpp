#include <harmos/scene/ProblemCost.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_CrsMatrix.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/scene/MemoryPerRank.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/detail/CostModel.hpp>
#include <harmos/scene/detail/MeasuredPart.hpp>
#include <harmos/scene/detail/SharedOperators.hpp>
#include <harmos/scene/detail/TouchedUnknowns.hpp>
#include <harmos/substructure/FactorPrediction.hpp>

namespace harmos::scene {
namespace {

substructure::FactorSize sizeOf(const assembly::Assembly& assembly, std::size_t number, FactorSizes sizes,
                                const substructure::SolverOptions& solver) {
  const substructure::Substructure& body = assembly.bodies[number];
  if (sizes == FactorSizes::fromOrder) {
    return substructure::predictFactor(*body.stiffness,
                                       boundaryOf(assembly.interfaces, number, assembly.dimension, body.nodes.size()),
                                       traceOf(assembly.interfaces, number, assembly.dimension), body.nodes, solver);
  }
  return factorOf(static_cast<double>(body.nodes.size()) * body.dimension, body.dimension);
}

/// Which bodies forces act on, of the volume or of boundaries.
std::vector<bool> areLoaded(const assembly::Assembly& assembly) {
  std::vector<bool> loaded;
  for (const substructure::Substructure& body : assembly.bodies) loaded.push_back(body.loads.numCols() > 0);
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (interface.law->prescribesTraction()) loaded[interface.body1] = true;
  }
  return loaded;
}

/// Whether a boundary that is eliminated moves the body, at load steps that stand for all of very many.
bool moves(const assembly::Interface& interface, int steps) {
  if (!isEliminated(interface)) return false;
  constexpr int looks = 64;
  for (int t = steps - 1; t >= 0; t -= std::max(1, steps / looks)) {
    for (const laws::AffineComponent& component : laws::affineComponents(*interface.law, t)) {
      if (std::isinf(component.stiffness) && component.offset != 0.0) return true;
    }
  }
  return false;
}

std::vector<bool> areMoved(const assembly::Assembly& assembly) {
  std::vector<bool> moved(assembly.bodies.size(), false);
  for (const assembly::Interface& interface : assembly.interfaces) {
    if (moves(interface, assembly.steps())) moved[interface.body1] = true;
  }
  return moved;
}

double mostPieces(const std::vector<mesh::Piece>& pieces) {
  std::map<std::pair<std::string, int>, double> counts;
  double most = 1.0;
  for (const mesh::Piece& piece : pieces) most = std::max(most, ++counts[{piece.part, piece.side}]);
  return most;
}

/// Of parts, by pieces that may be cut further, whose order says whether they are.
double nodesOfLargeParts(const std::vector<mesh::Piece>& pieces, int dimension) {
  std::map<std::pair<std::string, int>, double> nodes;
  for (const mesh::Piece& piece : pieces) nodes[{piece.part, piece.side}] += static_cast<double>(piece.nodes.size());
  double large = 0.0;
  for (const auto& [part, count] : nodes) large += count * dimension < leastUnknowns ? 0.0 : count;
  return large;
}

}  // namespace

CostEstimate estimateCost(const Problem& problem, const latin::LatinOptions& solver, FactorSizes sizes,
                          const Teuchos::Comm<int>& comm) {
  const assembly::Assembly& assembly = problem.assembly;
  const std::vector<double> interfaces = interfacesOf(assembly.interfaces, assembly.bodies.size());
  const std::vector<bool> loaded = areLoaded(assembly), moved = areMoved(assembly);
  CostScope scope;
  scope.dimension = assembly.dimension;
  scope.ranks = comm.getSize();
  scope.steps = assembly.steps();
  scope.isAffine = assembly.isAffine();
  scope.pieces = mostPieces(problem.bodies.pieces);
  scope.bodies = static_cast<double>(assembly.bodies.size());
  scope.softens = assembly.softens();
  const mesh::Elements elements(problem.mesh);
  for (const mesh::Piece& piece : problem.bodies.pieces) {
    scope.elements += static_cast<double>(piece.elements.size());
    if (!piece.elements.empty())
      scope.recoverySeconds +=
          static_cast<double>(piece.nodes.size()) * recoverySecondsOf(elements.type(piece.elements.front()));
  }
  scope.measured = nodesOfLargeParts(problem.bodies.pieces, assembly.dimension);
  std::vector<std::string> parts;
  for (const substructure::Substructure& body : assembly.bodies) parts.push_back(body.partName());
  scope.joints = jointGraphOf(assembly.interfaces, parts, assembly.dimension);
  // A rough estimate is made in every run, which asks statics itself.
  if (sizes == FactorSizes::fromOrder && !assembly.path) scope.statics = staticsOf(assembly, comm);
  CostSums sums;
  std::vector<std::optional<substructure::FactorSize>> known(assembly.bodies.size());
  SharedOperators operators(assembly.interfaces, assembly.dimension);
  std::vector<double> mineOfBody(assembly.bodies.size(), 0.0), ofBody(assembly.bodies.size(), 0.0);
  for (std::size_t b = 0; b < assembly.bodies.size(); ++b) {
    const substructure::Substructure& body = assembly.bodies[b];
    BodySize size;
    size.unknowns = static_cast<double>(body.nodes.size()) * assembly.dimension;
    scope.unknowns += size.unknowns;
    if (assembly.ownerOf(static_cast<int>(b)) != comm.getRank()) continue;
    // Congruent bodies share a matrix on every rank that has one of them.
    const std::size_t master = body.congruence ? static_cast<std::size_t>(body.congruence->representative) : b;
    const substructure::Substructure& first = assembly.bodies[master];
    const auto entries = static_cast<double>(first.stiffness->getGlobalNumEntries());
    if (body.iterates) size.iteratedEntries = entries;
    size.matrixEntries = entries;
    size.isAssembled = !known[master];
    if (size.isAssembled) {
      known[master] =
          body.iterates ? substructure::FactorSize{} : sizeOf(assembly, master, sizes, solver.stages.solver);
      mineOfBody[master] = known[master]->nonzeros / known[master]->blocks;
    }
    size.factor = *known[master];
    size.trace = static_cast<double>(traceOf(assembly.interfaces, b, assembly.dimension).size());
    size.interfaces = interfaces[b];
    size.held = static_cast<double>(heldOf(assembly.interfaces, b, assembly.dimension).size());
    size.isFactored = operators.add(b, body.nodes.size(), body.congruence.get(), body.iterates) == b;
    size.isLoaded = loaded[b];
    size.isMoved = moved[b];
    sums.add(size, solver);
  }
  sums.reduce(comm);
  scope.responses = static_cast<double>(problem.responses.size());
  for (const auto& response : problem.responses) {
    scope.work += response->work(assembly);
    if (response->isLinear()) scope.linearResponses += 1.0;
  }
  for (const auto& interface : assembly.interfaces) {
    if (isEliminated(interface)) scope.boundaryPairs += interface.pairs();
    scope.interfaceUnknowns += static_cast<double>(interface.pairs()) * interface.sides() * assembly.dimension;
    if (interface.sides() == 2) scope.sides += 2.0;
  }
  CostEstimate cost = sums.estimate(scope, solver);
  Teuchos::reduceAll(comm, Teuchos::REDUCE_MAX, static_cast<int>(ofBody.size()), mineOfBody.data(), ofBody.data());
  const auto largest = std::max_element(ofBody.begin(), ofBody.end());
  if (largest != ofBody.end()) {
    cost.largestFactor = *largest;
    cost.largestBody = assembly.bodies[largest - ofBody.begin()].name;
  }
  return cost;
}

void demandRoomForMesh(const Scene& scene, double freeBytes) {
  double nodes = 0.0, bytes = 0.0;
  std::set<std::pair<mesh::ElementType, double>> different;  // equal bodies share what they are solved with
  for (const mesh::BlockSize& block : meshSizes(scene.input.list("Mesh"))) {
    const double mine = block.elements * mesh::nodesForElement(block.type), components = mesh::dimensionOf(block.type);
    nodes += mine;
    if (!different.emplace(block.type, block.elements).second) continue;
    bytes += leastBytes(components * components * mine * mesh::meanNeighbours(block.type));
  }
  if (bytes <= uncertaintyOfCost * freeBytes) return;
  std::ostringstream message;
  message << "a mesh of about " << std::setprecision(2) << nodes << " nodes takes " << bytes / 1e9
          << " GB or more to solve, of which " << freeBytes / 1e9
          << " GB are free.\n  Take a coarser mesh, or more ranks on other machines.";
  throw base::Error(message.str(), base::ExitCode::input);
}

void demandCapacity(const CostEstimate& cost, double freeBytes) {
  std::ostringstream message;
  if (cost.largestFactor > mostEntriesOfFactor) {
    message << "part \"" << cost.largestBody << "\": its factor would have " << std::setprecision(2)
            << cost.largestFactor << " entries, more than direct solvers can number (" << mostEntriesOfFactor
            << ").\n  Cut it: add <Parameter name=\"Pieces\" type=\"int\" value=\"" << std::setprecision(0)
            << std::fixed << std::ceil(2.0 * std::pow(cost.largestFactor / mostEntriesOfFactor, 0.75))
            << "\"/> to the part, or solve it iteratively (\"Linear Solver\").";
    throw base::Error(message.str(), base::ExitCode::input);
  }
  if (cost.processBytes <= uncertaintyOfCost * freeBytes) return;
  message << "a run takes about " << std::setprecision(2) << cost.processBytes / 1e9 << " GB, of which "
          << freeBytes / 1e9
          << " GB are free.\n  Cut large parts (Pieces), solve them iteratively (Linear Solver), take a coarser mesh "
             "or fewer load steps, or more ranks on other machines.";
  throw base::Error(message.str(), base::ExitCode::input);
}

void demandCapacity(const Problem& problem, const latin::LatinOptions& solver, int derivatives,
                    const Teuchos::Comm<int>& comm) {
  const double freeBytes = memoryOfAllRanks(comm);
  const auto costBy = [&](FactorSizes sizes) {
    CostEstimate cost = estimateCost(problem, solver, sizes, comm);
    cost.addDerivatives(derivatives);
    return cost;
  };
  const CostEstimate rough = costBy(FactorSizes::fromUnknowns);
  if (rough.largestFactor <= mostEntriesOfFactor / uncertaintyOfCost &&
      rough.processBytes <= freeBytes / uncertaintyOfCost)
    return;
  demandCapacity(costBy(FactorSizes::fromOrder), freeBytes);
}

}  // namespace harmos::scene
