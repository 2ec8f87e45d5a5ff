#pragma once

#include <optional>
#include <string>
#include <vector>

#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/InterfaceSurface.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/mesh/SmoothPatches.hpp>

namespace harmos::mesh {

/// Collects the faces and the single nodes of one interface, between any pieces, and makes its surfaces of them: one
/// per pair of pieces that meet. Patches are those of the whole interface, so that they do not depend on how parts are
/// cut. Keeps references to the mesh and the pieces.
class SurfaceBuilders {
 public:
  /// `creaseAngle` [degrees] as for smoothPatches(). With a unit vector `projection`, from side 1 to side 2, it is the
  /// normal everywhere, nothing is divided, and gaps are measured along it; otherwise gaps are 0.
  SurfaceBuilders(const Mesh& mesh, const std::vector<Piece>& pieces, double creaseAngle,
                  const std::optional<base::Vector3>& projection = std::nullopt)
      : mesh_(mesh), pieces_(pieces), creaseAngle_(creaseAngle), projection_(projection) {}

  /// piece2 = -1 on an outer boundary; nodes2 in the order of nodes1, empty there; mesh node numbers. The mass may be
  /// left out.
  void addFace(int piece1, int piece2, const std::vector<int>& nodes1, const std::vector<int>& nodes2,
               FaceIntegrals integrals);
  /// A node pair that belongs to no face. Normals may have any length, also zero if there is no direction.
  void addNode(int piece1, int piece2, int node1, int node2, const NodalWeight& weight);

  /// By ascending pieces. Throws base::Error(input) if a pair has no area.
  std::vector<InterfaceSurface> build(const std::string& name) const;

 private:
  struct AddedFace {
    int piece1, piece2;
    FaceIntegrals integrals;
  };
  struct AddedNode {
    int piece1, piece2;
    NodePair pair;
    NodalWeight weight;
  };

  const Mesh& mesh_;
  const std::vector<Piece>& pieces_;
  double creaseAngle_;
  std::optional<base::Vector3> projection_;
  std::vector<OrientedFace> corners_;  // parallel to faces_
  std::vector<AddedFace> faces_;
  std::vector<AddedNode> nodes_;
};

}  // namespace harmos::mesh
