#include <harmos/scene/detail/SharedOperators.hpp>

#include <harmos/scene/detail/CostModel.hpp>

namespace harmos::scene {

std::size_t SharedOperators::add(std::size_t body, std::size_t nodes, const substructure::Congruence* congruence,
                                 bool iterates) {
  const std::size_t master = congruence ? static_cast<std::size_t>(congruence->representative) : body;
  substructure::BoundaryTerm term = boundaryOf(interfaces_, body, dimension_, nodes,
                                               congruence ? congruence->toRepresentative() : std::vector<int>{});
  auto& ofEqual = known_[{master, iterates}];
  for (const auto& [first, known] : ofEqual) {
    if (substructure::areEqual(known, term)) return first;
  }
  ofEqual.emplace_back(body, std::move(term));
  return body;
}

}  // namespace harmos::scene
