#pragma once

#include <string>
#include <utility>
#include <vector>

#include <harmos/mesh/CutMesh.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>

namespace harmos::mesh {

/// Mesh nodes that pieces of one part share with pieces of another, in any order; a node of several pieces may be there
/// several times.
std::vector<int> sharedNodes(const CutMesh& parts, const std::vector<int>& pieces1, const std::vector<int>& pieces2);

/// The surfaces of an interface that joins single nodes of some pieces with those of others, each with the mean of the
/// areas of both, see InterfaceFinder::betweenParts().
std::vector<InterfaceSurface> joinNodes(const CutMesh& parts, const std::string& name, const std::vector<int>& pieces1,
                                        const std::vector<int>& pieces2, const std::vector<std::pair<int, int>>& pairs);

}  // namespace harmos::mesh
