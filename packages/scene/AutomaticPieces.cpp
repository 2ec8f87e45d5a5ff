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
#include <harmos/scene/detail/CostModel.hpp>
#include <harmos/scene/detail/MeasuredPart.hpp>
#include <harmos/substructure/MultigridLibrary.hpp>

namespace harmos::scene {
namespace {

// Of the pieces that are tried.
constexpr double unknownsOfPieces[] = {3e4, 1.5e4, 8e3, 4e3};
// Of the time of the whole part: the model is not better than that.
constexpr double worthwhile = 0.75;
// Of the free memory, that what takes less than a whole part may be expected to take: it need not be certain to fit.
constexpr double shareOfMemory = 0.8;
// Iterations across cuts were measured down to this accuracy.
constexpr double finestAccuracy = 1e-5;
// In the plane and in space: interfaces of a piece that METIS cuts.
constexpr double neighbours[] = {6.0, 12.0};
// Of the surface of pieces, which are taken for cubes or squares: the rest is that of the part. Nodes along an edge
// that cuts add, for the same reason less than one.
constexpr double shareOfCuts = 0.8, addedNodes = 0.8;

/// Bodies after cuts, and what is estimated of them.
struct Candidate {
  std::map<std::string, int> pieces;
  std::set<std::string> iterated;
  CostEstimate cost;
  double seconds = 0.0;  // of the busiest rank
};

class Estimator {
 public:
  Estimator(const latin::LatinOptions& solver, const CostScope& scope, const std::vector<MeasuredPart>& wholes)
      : solver_(solver), scope_(scope), wholes_(wholes) {}

  /// Of pieces of about so many unknowns.
  Candidate cut(double unknownsOfPiece) const {
    Candidate result;
    CostScope scope = scope_;
    std::vector<BodySize> bodies;
    for (const MeasuredPart& whole : wholes_) {
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
    for (const MeasuredPart& whole : wholes_) {
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
  BodySize pieceOf(const MeasuredPart& whole, int count, CostScope& scope) const {
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
    scope.bodies += count - 1;
    scope.sides += count * neighbours[at];
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
      result.cost.largestFactor = std::max(result.cost.largestFactor, body.factor.nonzeros / body.factor.blocks);
    for (std::size_t rank = 0; rank < sums.size(); ++rank) {
      CostScope own = scope;
      own.ranks = 1;
      own.unknowns = unknowns[rank];
      own.bodies *= unknowns[rank] / scope.unknowns;
      own.sides *= unknowns[rank] / scope.unknowns;
      own.interfaceUnknowns = scope.interfaceUnknowns * unknowns[rank] / scope.unknowns;
      const CostEstimate here = sums[rank].estimate(own, solver_);
      result.seconds = std::max(result.seconds, here.seconds());
    }
  }

  const latin::LatinOptions& solver_;
  const CostScope& scope_;
  const std::vector<MeasuredPart>& wholes_;
};

/// Whether it takes no more than this share of the memory that is free.
bool fits(const Candidate& candidate, double share, double freeBytes) {
  return candidate.cost.largestFactor <= mostEntriesOfFactor / uncertaintyOfCost &&
         candidate.cost.processBytes <= share * freeBytes;
}

/// Those whose factors are the largest, until all fits; of no parts: it never does, or nothing can iterate.
Candidate iterateUntilItFits(const Estimator& estimator, const std::vector<MeasuredPart>& wholes, double freeBytes) {
  std::vector<const MeasuredPart*> order;
  for (const MeasuredPart& whole : wholes) {
    if (whole.mayIterate) order.push_back(&whole);
  }
  std::stable_sort(order.begin(), order.end(), [](const MeasuredPart* a, const MeasuredPart* b) {
    return a->size.factor.nonzeros > b->size.factor.nonzeros;
  });
  std::set<std::string> parts;
  for (const MeasuredPart* whole : order) {
    if (!parts.insert(whole->part).second) continue;
    Candidate candidate = estimator.iterate(parts);
    if (fits(candidate, shareOfMemory, freeBytes)) return candidate;
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
  const std::vector<MeasuredPart> wholes = measureParts(scene, mesh, whole, interfaces, dimension);
  CostScope scope;
  scope.dimension = dimension;
  scope.ranks = ranks;
  scope.steps = static_cast<int>(scene.times.size());
  scope.isAffine =
      std::all_of(interfaces.begin(), interfaces.end(), [](const auto& one) { return one.law->isAffine(); });
  std::vector<std::string> parts;
  for (const MeasuredPart& body : wholes) {
    scope.unknowns += body.size.unknowns;
    parts.push_back(body.part);
  }
  scope.bodies = static_cast<double>(wholes.size());
  scope.joints = jointGraphOf(interfaces, parts, dimension);
  for (const assembly::Interface& interface : interfaces) {
    scope.interfaceUnknowns += static_cast<double>(interface.pairs()) * interface.sides() * dimension;
    if (interface.sides() == 2) scope.sides += 2.0;
  }
  const Estimator estimator(scene.solver, scope, wholes);
  const Candidate uncut = estimator.cut(2.0 * scope.unknowns);
  const bool isTooLarge = !fits(uncut, 1.0 / uncertaintyOfCost, freeBytes);
  std::optional<Candidate> best;
  const bool isCutting = mayCut(scene, interfaces);
  for (const double unknowns : unknownsOfPieces) {
    if (!isCutting) break;
    Candidate candidate = estimator.cut(unknowns);
    if (candidate.pieces.empty() || !fits(candidate, shareOfMemory, freeBytes)) continue;
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
