#pragma once

#include <cstddef>
#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::scene {

/// Unknowns of a body, ascending, that interfaces touch, and boundaries that are not eliminated: those with affine
/// laws, as a rule.
std::vector<int> traceOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension);

/// What search directions and boundaries make of a body's stiffness, as far as it decides on the size of its factor:
/// the interface mass, as if all search directions were 1, and nodes at which boundaries are eliminated, as if they
/// were held in all directions.
substructure::BoundaryTerm boundaryOf(const std::vector<assembly::Interface>& interfaces, std::size_t body,
                                      int dimension, std::size_t nodes);

/// Whether a boundary stands in the operator of its body, as a rule.
bool isEliminated(const assembly::Interface& interface);

/// Unknowns of a body, ascending, at boundaries that are eliminated.
std::vector<int> heldOf(const std::vector<assembly::Interface>& interfaces, std::size_t body, int dimension);

/// How many interfaces and boundaries touch every body.
std::vector<double> interfacesOf(const std::vector<assembly::Interface>& interfaces, std::size_t bodies);

}  // namespace harmos::scene
