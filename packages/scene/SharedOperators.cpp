#include <harmos/scene/detail/SharedOperators.hpp>

#include <harmos/scene/detail/TouchedUnknowns.hpp>

namespace harmos::scene {

substructure::BoundaryTerm SharedOperators::termOf(std::size_t body, std::size_t nodes,
                                                   const std::vector<int>& toMaster) const {
  substructure::BoundaryTerm term;
  term.dimension = dimension_;
  term.diagonal.assign(nodes * static_cast<std::size_t>(dimension_), 0.0);
  const auto numberOf = [&](int node) { return toMaster.empty() ? node : toMaster[node]; };
  for (const assembly::Interface& interface : interfaces_) {
    if (interface.law->prescribesTraction() || isEliminated(interface)) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      if (interface.body(side) != static_cast<int>(body)) continue;
      for (int p = 0; p < interface.pairs(); ++p) {
        for (const auto& [node, weight] : interface.trace(side).row(p)) {
          for (int c = 0; c < dimension_; ++c) {
            term.diagonal[numberOf(node) * dimension_ + c] += weight * interface.area[p];
          }
        }
      }
    }
  }
  for (const int row : heldOf(interfaces_, body, dimension_)) {
    if (row % dimension_ == 0) term.free.push_back({numberOf(row / dimension_), {}});
  }
  substructure::arrange(term);
  return term;
}

std::size_t SharedOperators::add(std::size_t body, std::size_t nodes, const substructure::Congruence* congruence,
                                 bool iterates) {
  const std::size_t master = congruence ? static_cast<std::size_t>(congruence->representative) : body;
  substructure::BoundaryTerm term =
      termOf(body, nodes, congruence ? congruence->toRepresentative() : std::vector<int>{});
  auto& ofEqual = known_[{master, iterates}];
  for (const auto& [first, known] : ofEqual) {
    if (substructure::areEqual(known, term)) return first;
  }
  ofEqual.emplace_back(body, std::move(term));
  return body;
}

}  // namespace harmos::scene
