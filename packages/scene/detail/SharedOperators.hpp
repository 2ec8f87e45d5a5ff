#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
#include <harmos/substructure/Substructure.hpp>

namespace harmos::scene {

/// Which bodies are solved with one operator: those that are equal where interfaces touch them alike and boundaries
/// hold them alike, as latin::BodyOperators has it. Search directions, which are not known yet, count as 1.
class SharedOperators {
 public:
  /// Keeps a reference to the interfaces, which must outlive it and stay as they are.
  SharedOperators(const std::vector<assembly::Interface>& interfaces, int dimension)
      : interfaces_(interfaces), dimension_(dimension) {}

  /// Number of the body, among those asked about before, whose operator a body of so many nodes shares; its own if
  /// there is none. `congruence`: with the one that it equals; null: it equals none. `iterates`: it is not factored.
  std::size_t add(std::size_t body, std::size_t nodes, const substructure::Congruence* congruence, bool iterates);

 private:
  /// What holds the nodes of a body, in the numbering of what it equals: the interface mass, lumped, so that what
  /// points couple takes no memory, and where boundaries hold it.
  substructure::BoundaryTerm termOf(std::size_t body, std::size_t nodes, const std::vector<int>& toMaster) const;

  const std::vector<assembly::Interface>& interfaces_;
  int dimension_;
  /// The bodies that have operators, by what they equal and how they are solved, with what makes a difference.
  std::map<std::pair<std::size_t, bool>, std::vector<std::pair<std::size_t, substructure::BoundaryTerm>>> known_;
};

}  // namespace harmos::scene
