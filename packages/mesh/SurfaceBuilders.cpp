#include <harmos/mesh/detail/SurfaceBuilders.hpp>

#include <map>
#include <utility>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/detail/SurfaceBuilder.hpp>

namespace harmos::mesh {
namespace {

constexpr double anyAngle = 180.0;

}  // namespace

void SurfaceBuilders::addFace(int piece1, int piece2, const std::vector<int>& nodes1, const std::vector<int>& nodes2,
                              FaceIntegrals integrals) {
  OrientedFace& face = corners_.emplace_back();
  for (std::size_t i = 0; i < nodes1.size(); ++i) {
    face.pairs.emplace_back(nodes1[i], nodes2.empty() ? -1 : nodes2[i]);
    face.normal = face.normal + integrals.weight[i].flux;
  }
  faces_.push_back({piece1, piece2, std::move(integrals)});
}

void SurfaceBuilders::addNode(int piece1, int piece2, int node1, int node2, const NodalWeight& weight) {
  nodes_.push_back({piece1, piece2, {node1, node2}, weight});
}

std::vector<InterfaceSurface> SurfaceBuilders::build(const std::string& name) const {
  std::map<std::pair<int, int>, SurfaceBuilder> all;
  const auto at = [&](int piece1, int piece2) -> SurfaceBuilder& {
    return all.try_emplace({piece1, piece2}, mesh_, pieces_, piece1, piece2, projection_).first->second;
  };
  const auto patch = smoothPatches(corners_, projection_ ? anyAngle : creaseAngle_);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const AddedFace& face = faces_[f];
    SurfaceBuilder& builder = at(face.piece1, face.piece2);
    std::vector<SurfacePoint> corners;
    for (std::size_t i = 0; i < patch[f].size(); ++i) {
      const auto& [node1, node2] = corners_[f].pairs[i];
      corners.emplace_back(node1, node2, patch[f][i]);
    }
    builder.addFace(corners, face.integrals);
  }
  for (const AddedNode& node : nodes_) {
    at(node.piece1, node.piece2).addPoint({node.pair.first, node.pair.second, 0}, node.weight);
  }
  std::vector<InterfaceSurface> surfaces;
  for (const auto& [pieces, builder] : all) surfaces.push_back(builder.build(name));
  return surfaces;
}

}  // namespace harmos::mesh
