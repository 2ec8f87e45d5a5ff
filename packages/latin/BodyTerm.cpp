#include <harmos/latin/detail/BodyTerm.hpp>

#include <harmos/assembly/SideTerm.hpp>

namespace harmos::latin {

substructure::BoundaryTerm bodyTerm(const assembly::Assembly& assembly,
                                    const assembly::SearchDirection& searchDirection,
                                    const EliminatedBoundaries& eliminated, int body, const std::vector<int>& toMaster,
                                    const base::Frame* rotation) {
  const int dimension = assembly.dimension;
  substructure::BoundaryTerm term;
  term.dimension = dimension;
  term.diagonal.assign(assembly.bodies[body].nodes.size() * static_cast<std::size_t>(dimension), 0.0);
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (interface.law->prescribesTraction() || eliminated.contains(static_cast<int>(i))) continue;
    const std::vector<double>& k = searchDirection.of(static_cast<int>(i));
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) == body) assembly::addSideTerm(interface, side, k, toMaster, term);
    }
  }
  for (const EliminatedBoundaries::Node& node : eliminated.nodes(body)) {
    const int number = toMaster.empty() ? node.node : toMaster[node.node];
    const auto turned = [&](const base::Tensor3& a) { return rotation ? base::turnedBack(*rotation, a) : a; };
    if (base::distance(node.springs, {}) > 0.0) term.springs.push_back({number, turned(node.springs)});
    if (node.isHeld) term.free.push_back({number, turned(node.free)});
  }
  substructure::arrange(term);  // congruent bodies list their interfaces' nodes in other orders
  return term;
}

}  // namespace harmos::latin
