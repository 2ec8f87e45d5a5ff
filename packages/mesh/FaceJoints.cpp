#include <harmos/mesh/detail/FaceJoints.hpp>

#include <algorithm>
#include <map>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {

std::vector<InterfaceSurface> joinFaces(const CutMesh& parts, const std::string& name, const std::vector<Face>& side1,
                                        const std::vector<Face>& side2, const std::vector<FacePair>& pairs,
                                        double creaseAngle, const std::optional<base::Vector3>& projection) {
  SurfaceBuilders builders(parts.mesh, parts.pieces, creaseAngle, projection);
  for (const FacePair& pair : pairs) {
    const Face& face1 = side1[pair.face1];
    const Face& face2 = side2[pair.face2];
    const int piece1 = parts.map.of(face1.element);
    const int piece2 = parts.map.of(face2.element);
    if (parts.map.part(piece1) == parts.map.part(piece2)) {
      throw base::Error("Interface " + base::quoted(name) + ": both sides belong to part " +
                            base::quoted(parts.map.part(piece1)) +
                            "; an interface joins two parts. Divide the part into two blocks there.",
                        base::ExitCode::input);
    }
    builders.addFace(piece1, piece2, face1.nodes, pair.nodes2, parts.integrate(face1, projection));
  }
  return builders.build(name);
}

std::vector<InterfaceSurface> joinDifferentFaces(const CutMesh& parts, const std::string& name,
                                                 const std::vector<Face>& side1, const std::vector<Face>& side2,
                                                 double creaseAngle) {
  const auto onePiece = [&](const std::vector<Face>& side) {
    return std::all_of(side.begin(), side.end(),
                       [&](const Face& face) { return parts.map.of(face.element) == parts.map.of(side[0].element); });
  };
  const int piece1 = parts.map.of(side1[0].element);
  const int piece2 = parts.map.of(side2[0].element);
  if (!onePiece(side1) || !onePiece(side2) || parts.map.part(piece1) == parts.map.part(piece2)) return {};
  const auto pairs = matchNodes(parts.mesh, side1, side2);
  if (pairs.size() != nodesOf(side1).size() || pairs.size() != nodesOf(side2).size()) return {};
  const std::map<int, int> partner(pairs.begin(), pairs.end());
  std::map<int, int> inverse;
  for (const auto& [node1, node2] : pairs) inverse[node2] = node1;
  SurfaceBuilders builders(parts.mesh, parts.pieces, creaseAngle);
  using Sums = std::map<int, base::Vector3>;  // of normals, by node of side 1
  const auto halved = [&](const Face& face, const std::vector<int>& nodes1, double orientation, Sums& sums) {
    FaceIntegrals half = parts.integrate(face);
    half.mass.clear();
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      base::Vector3& sum = sums.try_emplace(nodes1[i]).first->second;
      sum = sum + half.weight[i].flux;
      half.weight[i] = half.weight[i].scaled(0.5, orientation);
    }
    return half;
  };
  const auto across = [](const std::vector<int>& nodes, const std::map<int, int>& to) {
    std::vector<int> result;
    for (const int node : nodes) result.push_back(to.at(node));
    return result;
  };
  Sums normal1, normal2;
  for (const Face& face : side1) {
    builders.addFace(piece1, piece2, face.nodes, across(face.nodes, partner), halved(face, face.nodes, 1.0, normal1));
  }
  for (const Face& face : side2) {
    const std::vector<int> nodes1 = across(face.nodes, inverse);
    builders.addShare(piece1, piece2, nodes1, face.nodes, halved(face, nodes1, -1.0, normal2));
  }
  double facing = 0.0;
  for (const auto& [node, normal] : normal1) facing += dot(normal, normal2.at(node));
  if (!(facing < 0.0)) return {};
  return builders.build(name);
}

}  // namespace harmos::mesh
