#pragma once

#include <map>
#include <vector>

#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/FaceIntegrals.hpp>
#include <harmos/mesh/PieceMap.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::mesh {

/// Gives single nodes an area, for interfaces without faces.
///
/// A node of the skin of the given pieces together has the sums of what FaceIntegrals gives it; an inner node the area
/// V^(2/3) (in 2-D (V times depth)^(1/2) off the axis), V being its share of the volume, and no normal. A node whose
/// faces all lie on the axis of revolution is an inner one.
/// Both are split over the pieces that own the faces or elements around the node.
class NodalWeights {
 public:
  /// For the elements of `pieces`; `wanted` are mesh nodes, ascending.
  NodalWeights(const Mesh& mesh, const Elements& elements, const PieceMap& map, const std::vector<int>& pieces,
               const std::vector<int>& wanted, const Depth& depth);

  /// Weights by piece; empty if none of the pieces has the node.
  const std::map<int, NodalWeight>& at(int node) const;
  /// The sum over the pieces.
  NodalWeight total(int node) const;

 private:
  std::map<int, std::map<int, NodalWeight>> weights_;
};

}  // namespace harmos::mesh
