#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/CurvedSurface.hpp>
#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Faces of a mesh that stand for a curved surface.
struct CurvedFaces {
  std::string name;                   ///< for messages
  std::vector<std::string> sideSets;  ///< of the mesh, which are parts of one surface
  CurvedSurface surface;              ///< that their nodes lie on
};

/// The surface of this kind that the nodes of side sets lie on. In the plane all are circles, and no cones. Throws
/// base::Error (input) naming side sets that the mesh does not have or that have no faces, and where nodes lie off the
/// surface by more than a thousandth of its radius: with the place and the distance.
CurvedFaces curvedFaces(const Mesh& mesh, const std::string& name, CurvedSurface::Kind kind,
                        const std::vector<std::string>& sideSets);

/// How many faces on the skin of a mesh lie on curved surfaces, in the box around their nodes, and are not among
/// those: they stay straight where new nodes come, and gaps or overlaps open to curved ones that they touch.
int straightBeside(const Mesh& mesh, const std::vector<CurvedFaces>& faces);

/// Moves the nodes from number `first` on that lie on faces of curved surfaces onto these, those on the rim of several
/// onto all of them. Throws base::Error (input) where surfaces do not meet there.
void moveOnto(const std::vector<CurvedFaces>& faces, int first, Mesh& mesh);

}  // namespace harmos::mesh
