#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/assembly/SearchDirection.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>
#include <harmos/substructure/BoundaryTerm.hpp>

namespace harmos::latin {

/// What interfaces and eliminated boundaries add to the stiffness of body `body`: B^T k h B of every interface side
/// [force/length], springs of foundations, and the free directions of held nodes. In the numbering of the body's
/// representative, which `toMaster` maps nodes to (empty: the body's own), and in its axes, which `rotation` turns into
/// those of the body (null: the same). Sorted, so that congruent bodies have equal terms.
substructure::BoundaryTerm bodyTerm(const assembly::Assembly& assembly,
                                    const assembly::SearchDirection& searchDirection,
                                    const EliminatedBoundaries& eliminated, int body, const std::vector<int>& toMaster,
                                    const base::Frame* rotation);

}  // namespace harmos::latin
