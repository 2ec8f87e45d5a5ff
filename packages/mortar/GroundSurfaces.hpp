#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Depth.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/PieceMap.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mortar {

/// A boundary whose tractions are linear between the corners of its faces, as laws need them that act between nodes on
/// faces of quadratic elements: points, areas and the trace operator are those that joinSurfaces() has where the same
/// mesh lies opposite.
///
/// Takes the faces of a boundary named `name`, each once, normals out of the part. One surface for every piece that has
/// some, by ascending pieces: on a cut each piece has points of its own. `pieces`: all, as `map` has them;
/// `creaseAngle` [degrees] as for mesh::smoothPatches(), `depth` in 2-D.
std::vector<mesh::InterfaceSurface> groundSurfaces(const std::string& name, const mesh::Mesh& mesh,
                                                   const std::vector<mesh::Face>& faces, double creaseAngle,
                                                   const mesh::Depth& depth, const std::vector<mesh::Piece>& pieces,
                                                   const mesh::PieceMap& map);

}  // namespace harmos::mortar
