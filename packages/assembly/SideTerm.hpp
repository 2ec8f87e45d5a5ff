#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::assembly {

/// Adds B^T k h B [force/length] of a side (0 or 1) of an interface to the term of its body, which has its dimension
/// and, where B selects nodes and h is lumped, its diagonal. `k` [stress/length]: of every pair. `numbers`: of the
/// nodes of the body in the term; empty: their own. Not collective.
void addSideTerm(const Interface& interface, int side, const std::vector<double>& k, const std::vector<int>& numbers,
                 substructure::BoundaryTerm& term);

}  // namespace harmos::assembly
