#pragma once

#include <vector>

#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::mesh {

/// Which pair of which surface carries the unknowns of a pair; surface = -1: none, its nodes are tied by other pairs.
struct PairCarrier {
  int surface = -1;  // index into the list of surfaces
  int pair = -1;     // of that surface
};

/// Leaves every joint of pieces of cut parts as many node pairs as it needs, so that interface forces are determinate.
///
/// Where a cut meets an interface or a boundary, the same nodes of a part are paired once for every piece: the pair
/// with the largest area keeps the sums of the areas and of the normals and carries them all; patches stay apart. Where
/// several pieces share a node, only pairs that tie pieces not yet tied keep theirs (a spanning tree, largest areas
/// first). Pairs of a surface whose points feel several nodes all keep theirs. The result is the joint of the uncut
/// parts. `surfaces` keeps all pairs and faces; the areas, normals and frames of carriers at interfaces and boundaries
/// change, their mass does not. `dimension`: 2 or 3. Returns one entry per pair of every surface.
std::vector<std::vector<PairCarrier>> mergeRedundantPairs(const std::vector<Piece>& pieces, int dimension,
                                                          std::vector<InterfaceSurface>& surfaces);

}  // namespace harmos::mesh
