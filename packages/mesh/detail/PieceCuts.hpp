#pragma once

#include <vector>

#include <harmos/mesh/CutMesh.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>

namespace harmos::mesh {

/// The surfaces between the pieces of every part that was cut, see InterfaceFinder::cuts().
std::vector<InterfaceSurface> pieceCuts(const CutMesh& parts);

}  // namespace harmos::mesh
