#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/Response.hpp>
#include <harmos/scene/Bodies.hpp>
#include <harmos/scene/Temperatures.hpp>
#include <harmos/scene/detail/PartPieces.hpp>

namespace harmos::scene {

/// Stress at the nodes of one part of the scene, recovered from its elements by recovery::StressRecovery: continuous in
/// the part, with nothing averaged over its boundary.
class PartStress {
 public:
  /// Of all parts, in the order of the list Parts. Nothing of the arguments is kept but the materials, which are
  /// shared.
  static std::vector<PartStress> ofAll(const mesh::Mesh& mesh, const Bodies& bodies, const Model& model,
                                       const Temperatures& temperatures);

  /// Name of the part.
  const std::string& name() const { return part_.name; }
  /// Bodies that it was cut into, positions in the assembly.
  const std::vector<int>& bodies() const { return part_.bodies; }
  /// Its node that a node of its body number `i` of bodies() is.
  int node(std::size_t i, int nodeOfBody) const { return nodeOfPart_[i][nodeOfBody]; }
  /// Nodes of that body.
  int nodes(std::size_t i) const { return static_cast<int>(nodeOfPart_[i].size()); }
  /// Of the columns [first, first + count) of a state: six components per node as elasticity::elementStress() has them,
  /// (6 nodes) x count [stress], on the rank that owns its first body; elsewhere 0 x 0. Collective. Throws as
  /// StressRecovery.
  base::Matrix recover(const latin::Iterate& state, int first, int count) const;
  /// What recovering a column takes: nodes of the part, by how the polynomials that are fitted at them compare in time
  /// with those of Hex8.
  latin::ResponseWork work() const;

 private:
  PartStress(const mesh::Mesh& mesh, const Bodies& bodies, const Model& model, const Temperatures& temperatures,
             PartPieces part);

  mesh::Mesh mesh_;  // of the part alone: its nodes are those of the piece
  PartPieces part_;
  std::vector<std::vector<int>> nodeOfPart_;  // per body and node
  std::shared_ptr<const elasticity::Material> material_;
  elasticity::Formulation formulation_;
  Model model_;
  base::Matrix temperature_;  // Temperatures::of() the part
  std::vector<bool> boundary_;
};

}  // namespace harmos::scene
