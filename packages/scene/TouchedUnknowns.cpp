#include <harmos/scene/detail/TouchedUnknowns.hpp>

#include <set>

#include <harmos/assembly/SideTerm.hpp>

namespace harmos::scene {
namespace {

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

bool isEliminated(const assembly::Interface& interface) {
  return interface.sides() == 1 && interface.mass.empty() && interface.law->isAffine() &&
         !interface.law->prescribesTraction();
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
  for (const assembly::Interface& interface : interfaces) {
    if (interface.law->prescribesTraction() || isEliminated(interface)) continue;
    const std::vector<double> k(static_cast<std::size_t>(interface.pairs()), 1.0);
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) == static_cast<int>(body)) assembly::addSideTerm(interface, side, k, {}, term);
    }
  }
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

}  // namespace harmos::scene
