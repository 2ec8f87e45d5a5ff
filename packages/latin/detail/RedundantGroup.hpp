#pragma once

#include <vector>

#include <harmos/assembly/Assembly.hpp>
#include <harmos/base/Matrix.hpp>
#include <harmos/latin/EliminatedBoundaries.hpp>

namespace harmos::latin {

/// Pairs that meet at nodes of bodies in such a way that these may not tell their tractions apart: a chain of pairs
/// from node to node that closes in itself, that ends on the ground twice, or at nodes that eliminated boundaries hold.
struct RedundantGroup {
  /// A pair of an eliminated boundary that holds one of the nodes of a pair: it takes what the pair gives up there.
  struct Holder {
    int interface = -1;  ///< position in the assembly
    int pair = -1;       ///< of the interface
    double share = 1.0;  ///< force on that node over the force on side 1
  };
  /// A pair with unknowns.
  struct Pair {
    int interface = -1;                ///< position in the assembly
    int pair = -1;                     ///< of the interface
    double area = 0.0;                 ///< h [area]
    std::vector<Holder> holders = {};  ///< of both of its nodes
  };

  std::vector<Pair> pairs;  ///< in the order of the assembly
  /// What the tractions do to the nodes of the group in the directions that no eliminated boundary holds: nodal forces
  /// [force] from tractions on side 1 times sqrt(h) [force / length], rows x (3 pairs), in global components.
  base::Matrix equilibrium;
};

/// All groups of an assembly; the same on every rank, not collective. Left out are interfaces with a consistent mass,
/// whose nodes do not act one by one, and groups of more than assembly::NodeClusters::mostPairs pairs.
std::vector<RedundantGroup> findRedundantGroups(const assembly::Assembly& assembly,
                                                const EliminatedBoundaries& eliminated);

}  // namespace harmos::latin
