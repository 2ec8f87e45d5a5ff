#include <harmos/scene/detail/AutomaticPieces.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include <harmos/base/Names.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/scene/detail/CostModel.hpp>
#include <harmos/substructure/MirrorPlanes.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

namespace harmos::scene {
namespace {

// Unknowns of a part below which it is never cut, and of the pieces that are tried.
constexpr double leastUnknowns = 6e4;
constexpr double unknownsOfPieces[] = {3e4, 1.5e4, 8e3, 4e3};
// Of the time of the whole part: the model is not better than that.
constexpr double worthwhile = 0.75;
// Of the memory that is free, and of the entries that solvers can number.
constexpr double shareOfMemory = 0.8, mostEntries = 2147483647.0 / 1.5;
// Iterations across cuts were measured down to this accuracy.
constexpr double finestAccuracy = 1e-5;
// In the plane and in space: interfaces of a piece that METIS cuts, and powers of the unknowns with which entries and
// operations of a factor fall from a part to its pieces.
constexpr double neighbours[] = {6.0, 12.0}, growthOfEntries[] = {1.1, 1.42}, growthOfOperations[] = {1.5, 2.0};
// Of the surface of pieces, which are taken for cubes or squares: the rest is that of the part. Nodes along an edge
// that cuts add, for the same reason less than one.
constexpr double shareOfCuts = 0.8, addedNodes = 0.8;

/// A body with what has to be known to cut it.
struct Whole {
  BodySize size;
  substructure::FactorSize plain;  // of its operator, if no mirror plane cut it
  double nodes = 0.0;
  bool isOpen = false;      // it may be cut
  bool mayIterate = false;  // it may be solved iteratively
  std::string part;
};

/// Nodes that share elements, as compressed rows, each node with itself.
struct NodeGraph {
  std::vector<std::size_t> first{0};
  std::vector<int> columns;
};

NodeGraph graphOf(const mesh::Elements& elements, const mesh::Piece& piece) {
  std::vector<std::vector<int>> near(piece.nodes.size());
  for (const int element : piece.elements) {
    std::vector<int> own;
    const int* nodes = elements.nodes(element);
    for (int a = 0; a < mesh::nodesPerElement(elements.type(element)); ++a)
      own.push_back(mesh::localNode(piece, nodes[a]));
    for (const int node : own) near[node].insert(near[node].end(), own.begin(), own.end());
  }
  NodeGraph graph;
  for (std::vector<int>& row : near) {
    std::sort(row.begin(), row.end());
    graph.columns.insert(graph.columns.end(), row.begin(), std::unique(row.begin(), row.end()));
    graph.first.push_back(graph.columns.size());
  }
  return graph;
}

/// Stiffness and factor from the neighbours of nodes.
void measure(const NodeGraph& graph, int dimension, BodySize& size) {
  const double components = dimension;
  size.matrixEntries = components * components * static_cast<double>(graph.columns.size());
  size.factor =
      substructure::NestedDissection(static_cast<int>(graph.first.size()) - 1, graph.first.data(), graph.columns.data())
          .factorSize();
  size.factor.nonzeros *= components * components;
  size.factor.operations *= components * components * components;
  size.factor.bytes *= components * components;
}

/// The factors of a body that is cut by the mirror planes of its nodes, their neighbours, its trace and what holds it.
substructure::FactorSize mirrored(const substructure::FactorSize& plain, const std::vector<base::Vector3>& nodes,
                                  const NodeGraph& graph, int dimension, const std::vector<int>& trace,
                                  const std::vector<int>& held) {
  substructure::MirrorPlanes planes(nodes, dimension);
  planes.keepThoseOf(trace);
  planes.keepThoseOf(held);
  // As a matrix on the first components, all entries of which are alike.
  std::vector<std::size_t> pointers{0};
  std::vector<int> columns;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    for (std::size_t k = graph.first[node]; k < graph.first[node + 1]; ++k)
      columns.push_back(graph.columns[k] * dimension);
    pointers.insert(pointers.end(), static_cast<std::size_t>(dimension), columns.size());
  }
  const std::vector<double> values(columns.size(), 1.0);
  planes.keepThoseOf({static_cast<int>(pointers.size()) - 1, pointers.data(), columns.data(), values.data()});
  substructure::FactorSize size = plain;
  size.blocks = 1 << planes.count();
  const double entries = std::pow(size.blocks, 1.0 - growthOfEntries[dimension - 2]);
  size.nonzeros *= entries;
  size.bytes *= entries;
  size.operations *= std::pow(size.blocks, 1.0 - growthOfOperations[dimension - 2]);
  return size;
}

std::vector<Whole> measureAll(const Scene& scene, const mesh::Mesh& mesh, const Bodies& bodies,
                              const std::vector<assembly::Interface>& interfaces, int dimension) {
  std::vector<std::vector<int>> trace, held;
  for (std::size_t b = 0; b < bodies.pieces.size(); ++b) {
    trace.push_back(traceOf(interfaces, b, dimension));
    held.push_back(heldOf(interfaces, b, dimension));
  }
  const std::vector<double> touching = interfacesOf(interfaces, bodies.pieces.size());
  std::set<std::string> given, solverGiven;
  for (const input::Parameters& part : scene.input.lists("Parts")) {
    if (part.has("Pieces")) given.insert(part.name());
    if (part.has("Linear Solver")) solverGiven.insert(part.name());
  }
  const mesh::Elements elements(mesh);
  std::vector<Whole> all;
  for (std::size_t b = 0; b < bodies.pieces.size(); ++b) {
    const mesh::Piece& piece = bodies.pieces[b];
    Whole& body = all.emplace_back();
    body.part = piece.part;
    body.nodes = static_cast<double>(piece.nodes.size());
    body.size.unknowns = dimension * body.nodes;
    body.size.trace = static_cast<double>(trace[b].size());
    body.size.interfaces = touching[b];
    const bool isLarge = body.size.unknowns >= leastUnknowns;
    body.mayIterate = isLarge && solverGiven.count(piece.part) == 0;
    body.isOpen = isLarge && piece.side == 0 && given.count(piece.part) == 0 && !bodies.parts[b].iterates;
    if (bodies.parts[b].iterates) {
      body.size.iteratedEntries = operatorEntries(body.size.unknowns, dimension);
      continue;
    }
    // Parts of as many nodes and elements are taken for equal.
    const auto isEqual = [&](std::size_t a) {
      return bodies.pieces[a].nodes.size() == piece.nodes.size() && bodies.materials[a] == bodies.materials[b] &&
             bodies.pieces[a].elements.size() == piece.elements.size() &&
             bodies.parts[a].formulation == bodies.parts[b].formulation;
    };
    std::size_t master = 0;
    while (!isEqual(master)) ++master;
    if (master < b) {
      body.size.factor = all[master].size.factor;
      body.plain = all[master].plain;
      for (std::size_t a = master; a < b; ++a) {
        if (isEqual(a) && trace[a].size() == trace[b].size() && held[a].size() == held[b].size())
          body.size.isFactored = false;
      }
      continue;
    }
    body.size.factor = factorOf(body.size.unknowns, dimension);
    body.size.matrixEntries = operatorEntries(body.size.unknowns, dimension);
    body.plain = body.size.factor;
    if (!isLarge) continue;
    const NodeGraph graph = graphOf(elements, piece);
    measure(graph, dimension, body.size);
    body.plain = body.size.factor;
    std::vector<base::Vector3> nodes;
    for (const int node : piece.nodes) nodes.push_back(mesh.nodes[node]);
    body.size.factor = mirrored(body.plain, nodes, graph, dimension, trace[b], held[b]);
  }
  return all;
}

/// Bodies after cuts, and what is estimated of them.
struct Candidate {
  std::map<std::string, int> pieces;
  std::set<std::string> iterated;
  CostEstimate cost;
  double seconds = 0.0;  // of the busiest rank
};

class Estimator {
 public:
  Estimator(const latin::LatinOptions& solver, const CostScope& scope, const std::vector<Whole>& wholes)
      : solver_(solver), scope_(scope), wholes_(wholes) {}

  /// Of pieces of about so many unknowns.
  Candidate cut(double unknownsOfPiece) const {
    Candidate result;
    CostScope scope = scope_;
    std::vector<BodySize> bodies;
    for (const Whole& whole : wholes_) {
      const int count = whole.isOpen ? static_cast<int>(std::lround(whole.size.unknowns / unknownsOfPiece)) : 1;
      if (count < 2) {
        bodies.push_back(whole.size);
        continue;
      }
      result.pieces[whole.part] = count;
      scope.pieces = std::max(scope.pieces, static_cast<double>(count));
      const BodySize piece = pieceOf(whole, count, scope);
      bodies.insert(bodies.end(), static_cast<std::size_t>(count), piece);
    }
    estimate(bodies, scope, result);
    return result;
  }

  /// In one piece each, with these parts solved iteratively.
  Candidate iterate(const std::set<std::string>& parts) const {
    Candidate result;
    result.iterated = parts;
    std::vector<BodySize> bodies;
    for (const Whole& whole : wholes_) {
      bodies.push_back(whole.size);
      if (parts.count(whole.part) == 0) continue;
      bodies.back().iteratedEntries = operatorEntries(whole.size.unknowns, scope_.dimension);
      bodies.back().factor = {};
    }
    estimate(bodies, scope_, result);
    return result;
  }

 private:
  /// One of `count` pieces; adds what cuts add to the scope.
  BodySize pieceOf(const Whole& whole, int count, CostScope& scope) const {
    const int space = scope_.dimension == 2 ? 2 : 3, at = space - 2;
    const double side = std::pow(whole.nodes / count, 1.0 / space), components = scope_.dimension;
    const double cutUnknowns = shareOfCuts * components * 2.0 * space * std::pow(side, space - 1);
    BodySize piece;
    piece.unknowns = components * std::pow(side + addedNodes, space);
    piece.trace = std::min(piece.unknowns, whole.size.trace / count + cutUnknowns);
    piece.interfaces = whole.size.interfaces / count + neighbours[at];
    piece.matrixEntries = operatorEntries(piece.unknowns, scope_.dimension);
    const double share = piece.unknowns / whole.size.unknowns, entries = std::pow(share, growthOfEntries[at]);
    piece.factor.nonzeros = entries * whole.plain.nonzeros;
    piece.factor.bytes = entries * whole.plain.bytes;
    piece.factor.operations = std::pow(share, growthOfOperations[at]) * whole.plain.operations;
    scope.unknowns += count * piece.unknowns - whole.size.unknowns;
    scope.interfaceUnknowns += count * cutUnknowns;
    return piece;
  }

  void estimate(const std::vector<BodySize>& bodies, const CostScope& scope, Candidate& result) const {
    CostSums all;
    std::vector<CostSums> sums(static_cast<std::size_t>(scope.ranks));
    std::vector<double> unknowns(sums.size(), 0.0), load(sums.size(), 0.0);
    std::vector<const BodySize*> order;
    for (const BodySize& body : bodies) order.push_back(&body);
    std::stable_sort(order.begin(), order.end(),
                     [](const BodySize* a, const BodySize* b) { return a->unknowns > b->unknowns; });
    for (const BodySize* body : order) {
      all.add(*body, solver_);
      const auto least = static_cast<std::size_t>(std::min_element(load.begin(), load.end()) - load.begin());
      load[least] += std::pow(body->unknowns, 4.0 / 3.0);
      unknowns[least] += body->unknowns;
      sums[least].add(*body, solver_);
    }
    result.cost = all.estimate(scope, solver_);
    for (const BodySize& body : bodies)
      result.cost.largestFactor = std::max(result.cost.largestFactor, body.factor.nonzeros);
    for (std::size_t rank = 0; rank < sums.size(); ++rank) {
      CostScope own = scope;
      own.ranks = 1;
      own.unknowns = unknowns[rank];
      own.interfaceUnknowns = scope.interfaceUnknowns * unknowns[rank] / scope.unknowns;
      const CostEstimate here = sums[rank].estimate(own, solver_);
      result.seconds = std::max(result.seconds, here.startSeconds + here.factorSeconds +
                                                    result.cost.stages * here.stageSeconds + here.resultSeconds);
    }
  }

  const latin::LatinOptions& solver_;
  const CostScope& scope_;
  const std::vector<Whole>& wholes_;
};

bool fits(const Candidate& candidate, double freeBytes) {
  return candidate.cost.largestFactor <= mostEntries && candidate.cost.processBytes <= shareOfMemory * freeBytes;
}

/// Those whose factors are the largest, until all fits; of no parts: it never does, or nothing can iterate.
Candidate iterateUntilItFits(const Estimator& estimator, const std::vector<Whole>& wholes, double freeBytes) {
  std::vector<const Whole*> order;
  for (const Whole& whole : wholes) {
    if (whole.mayIterate) order.push_back(&whole);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Whole* a, const Whole* b) { return a->size.factor.nonzeros > b->size.factor.nonzeros; });
  std::set<std::string> parts;
  for (const Whole* whole : order) {
    if (!parts.insert(whole->part).second) continue;
    Candidate candidate = estimator.iterate(parts);
    if (fits(candidate, freeBytes)) return candidate;
  }
  return {};
}

std::string describeIterated(const Candidate& iterated, const Candidate& whole) {
  std::ostringstream text;
  const char* separator = "solve";
  for (const std::string& part : iterated.iterated) {
    text << separator << " " << base::quoted(part);
    separator = ",";
  }
  text << std::setprecision(2) << " iteratively: about " << iterated.cost.processBytes / 1e9 << " instead of "
       << whole.cost.processBytes / 1e9 << " GB, which is too much, and " << iterated.seconds << " instead of "
       << whole.seconds << " s; Linear Solver = Direct factors a part";
  return text.str();
}

std::string describe(const Candidate& cut, const Candidate& whole, bool wasTooLarge) {
  std::ostringstream text;
  const char* separator = "cut";
  for (const auto& [part, pieces] : cut.pieces) {
    text << separator << " " << base::quoted(part) << " into " << pieces << " pieces";
    separator = ",";
  }
  text << std::setprecision(2) << ": about " << cut.seconds << " instead of " << whole.seconds << " s and "
       << cut.cost.processBytes / 1e9 << " instead of " << whole.cost.processBytes / 1e9 << " GB"
       << (wasTooLarge ? ", which is too much" : "") << "; Pieces = 1 keeps a part whole";
  return text.str();
}

bool mayCut(const Scene& scene, const std::vector<assembly::Interface>& interfaces) {
  const latin::LatinOptions& solver = scene.solver;
  const bool softens =
      std::any_of(interfaces.begin(), interfaces.end(), [](const auto& one) { return one.law->lowestSlope() < 0.0; });
  return solver.algorithm == latin::Algorithm::accelerated &&
         solver.stages.formulation == latin::Formulation::displacement && solver.stages.macroProblem &&
         solver.accuracy >= finestAccuracy && !scene.input.hasList("Path Following") && !softens;
}

}  // namespace

PieceChoice choosePieces(const Scene& scene, const mesh::Mesh& mesh, const Bodies& whole,
                         const std::vector<assembly::Interface>& interfaces, int dimension, int ranks,
                         double freeBytes) {
  const bool isSmall = std::all_of(whole.pieces.begin(), whole.pieces.end(), [&](const mesh::Piece& piece) {
    return dimension * static_cast<double>(piece.nodes.size()) < leastUnknowns;
  });
  if (isSmall) return {};
  const std::vector<Whole> wholes = measureAll(scene, mesh, whole, interfaces, dimension);
  CostScope scope;
  scope.dimension = dimension;
  scope.ranks = ranks;
  scope.steps = static_cast<int>(scene.times.size());
  scope.isAffine =
      std::all_of(interfaces.begin(), interfaces.end(), [](const auto& one) { return one.law->isAffine(); });
  for (const Whole& body : wholes) scope.unknowns += body.size.unknowns;
  for (const assembly::Interface& interface : interfaces)
    scope.interfaceUnknowns += static_cast<double>(interface.pairs()) * interface.sides() * dimension;
  const Estimator estimator(scene.solver, scope, wholes);
  const Candidate uncut = estimator.cut(2.0 * scope.unknowns);
  const bool isTooLarge = !fits(uncut, freeBytes);
  std::optional<Candidate> best;
  const bool isCutting = mayCut(scene, interfaces);
  for (const double unknowns : unknownsOfPieces) {
    if (!isCutting) break;
    Candidate candidate = estimator.cut(unknowns);
    if (candidate.pieces.empty() || !fits(candidate, freeBytes)) continue;
    if (!isTooLarge && candidate.seconds > worthwhile * uncut.seconds) continue;
    if (!best || candidate.seconds < best->seconds) best = std::move(candidate);
  }
  if (best) return {best->pieces, {}, describe(*best, uncut, isTooLarge)};
  if (!isTooLarge || !substructure::hasMultigrid()) return {};
  const Candidate iterated = iterateUntilItFits(estimator, wholes, freeBytes);
  if (iterated.iterated.empty()) return {};
  return {{}, iterated.iterated, describeIterated(iterated, uncut)};
}

}  // namespace harmos::scene
