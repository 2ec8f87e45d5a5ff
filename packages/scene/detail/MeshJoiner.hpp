#pragma once

#include <string>
#include <vector>

#include <harmos/input/Parameters.hpp>
#include <harmos/laws/InterfaceLaw.hpp>
#include <harmos/mesh/InterfaceFinder.hpp>
#include <harmos/mortar/JoinSurfaces.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/JoinedMeshes.hpp>

namespace harmos::scene {

/// Joins the meshes of an interface that do not match, as its list in the scene asks for. Keeps references to all but
/// the options.
class MeshJoiner {
 public:
  /// `list`: of the interface, whose law `law` is; `depth` as for mesh::InterfaceFinder; `held`: by boundaries of the
  /// scene, which counts where the law carries tractions along the surface.
  MeshJoiner(const input::Parameters& list, const laws::InterfaceLaw& law, const mesh::Depth& depth,
             const mortar::HeldDirections& held, const mesh::Mesh& mesh, const Bodies& bodies,
             const mesh::InterfaceFinder& finder);

  /// The surfaces between all pieces, and a line of `reports`. Where cuts of METIS divide what a point sees, there are
  /// none, and `crossed` gets the nodes of the sides that must not be divided. Throws base::Error(input) if the sides
  /// share a part, cannot be joined, or if points see nodes of several pieces although these are together.
  std::vector<mesh::InterfaceSurface> join(const std::string& name1, const std::vector<mesh::Face>& side1,
                                           const std::string& name2, const std::vector<mesh::Face>& side2,
                                           std::vector<JoinedMeshes>& reports, KeptTogether& crossed) const;

 private:
  std::string partOf(const mesh::Face& face) const;
  double stiffnessOf(const std::vector<mesh::Face>& side) const;
  /// Adds the nodes of a side, part by part, where they are not together yet; whether there were such.
  bool keepTogether(const std::vector<mesh::Face>& side, const std::string& remedy, KeptTogether& crossed) const;
  /// What lets this side be cut: the points on it, and the parts of the other side whole.
  std::string pointsMoved(int side, const std::vector<mesh::Face>& other) const;
  void demandTwoParts(const std::vector<mesh::Face>& side1, const std::vector<mesh::Face>& side2) const;

  const std::string& name_;
  bool isOfSideSets_, hasGaps_;
  mortar::JoinOptions options_;
  const mesh::Mesh& mesh_;
  const Bodies& bodies_;
  const mesh::InterfaceFinder& finder_;
};

}  // namespace harmos::scene
