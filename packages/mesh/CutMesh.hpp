#pragma once

#include <optional>
#include <vector>

#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mesh/PieceMap.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// A mesh and the pieces that its parts are cut into, with what is looked up to find surfaces between them. Keeps
/// references to both, which must outlive it and stay as they are.
struct CutMesh {
  /// `thickness` multiplies lengths in 2-D and does not count in 3-D. Throws base::Error(input) if two parts share an
  /// element.
  CutMesh(const Mesh& ofAll, const std::vector<Piece>& ofParts, const Depth& thickness)
      : mesh(ofAll),
        pieces(ofParts),
        depth(mesh.dimension == 2 ? thickness : Depth()),
        elements(mesh),
        map(mesh, elements, pieces) {}

  /// Integrals over a face, see integrateFace().
  FaceIntegrals integrate(const Face& face, const std::optional<base::Vector3>& projection = std::nullopt) const {
    return integrateFace(mesh.dimension, pointsOf(mesh, face.nodes), depth, projection);
  }

  const Mesh& mesh;                  ///< all of it
  const std::vector<Piece>& pieces;  ///< into which its parts are cut
  Depth depth;                       ///< that of the faces
  Elements elements;                 ///< of the mesh, by number
  PieceMap map;                      ///< to which pieces they belong
};

}  // namespace harmos::mesh
