#pragma once

#include <vector>

#include <harmos/base/Tpetra.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>
#include <harmos/substructure/MirrorPlanes.hpp>

namespace harmos::substructure {

/// The planes in which a part is its own mirror image with all that belongs to its operator: `nodes` [length],
/// stiffness K, what a boundary adds and holds, and the rows of its trace, ascending. None without nodes and in small
/// parts.
MirrorPlanes operatorPlanes(const std::vector<base::Vector3>& nodes, const base::CrsMatrix& stiffness,
                            const BoundaryTerm& boundary, const std::vector<int>& trace);

/// Where rows of a trace stand in a block that they belong to. `block` and `trace`: rows of the part, ascending;
/// `own`: places in `trace`.
std::vector<int> placesInBlock(const std::vector<int>& block, const std::vector<int>& trace,
                               const std::vector<int>& own);

}  // namespace harmos::substructure
