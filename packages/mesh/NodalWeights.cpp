#include <harmos/mesh/detail/NodalWeights.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {
namespace {

/// Volume of an element by the divergence theorem, 3 V = int x.n dS; of constant thickness in 2-D 2 V = int x.n dS.
double volume(const Mesh& mesh, const Elements& elements, int element, const Depth& depth) {
  double flux = 0.0;
  for (int side = 0; side < sidesPerElement(elements.type(element)); ++side) {
    const auto corners = pointsOf(mesh, elements.side(element, side));
    const FaceIntegrals face = integrateFace(mesh.dimension, corners, depth);
    for (std::size_t i = 0; i < corners.size(); ++i) flux += dot(corners[i], face.weight[i].flux);
  }
  return flux / (depth.isRevolved() ? 3 : mesh.dimension);
}

}  // namespace

NodalWeights::NodalWeights(const Mesh& mesh, const Elements& elements, const PieceMap& map,
                           const std::vector<int>& pieces, const std::vector<int>& wanted, const Depth& depth) {
  if (wanted.empty()) return;
  const auto elementList = map.elements(pieces);
  const auto isWanted = [&](int node) { return std::binary_search(wanted.begin(), wanted.end(), node); };
  for (const Face& face : skinAt(elements, elementList, wanted)) {
    const FaceIntegrals integrals = integrateFace(mesh.dimension, pointsOf(mesh, face.nodes), depth);
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      // What lies on the axis of revolution is inside of the part.
      if (!isWanted(face.nodes[i]) || (depth.isRevolved() && integrals.weight[i].area == 0.0)) continue;
      weights_[face.nodes[i]][map.of(face.element)] += integrals.weight[i];
    }
  }
  std::map<int, std::map<int, double>> volumes;
  for (const int element : elementList) {
    const int count = nodesPerElement(elements.type(element));
    const int* nodes = elements.nodes(element);
    const auto isInner = [&](int node) { return isWanted(node) && weights_.count(node) == 0; };
    if (std::none_of(nodes, nodes + count, isInner)) continue;
    const double share = volume(mesh, elements, element, depth) / count;
    for (int i = 0; i < count; ++i) {
      if (isInner(nodes[i])) volumes[nodes[i]][map.of(element)] += share;
    }
  }
  for (const auto& [node, byPiece] : volumes) {
    double total = 0.0;
    for (const auto& [owner, part] : byPiece) total += part;
    const double length = mesh.dimension == 3 ? 0.0 : depth.at(mesh.nodes[node]);
    const double area = length > 0.0 ? std::sqrt(std::abs(total) * length) : std::pow(std::abs(total), 2.0 / 3.0);
    for (const auto& [owner, part] : byPiece) {
      NodalWeight& weight = weights_[node][owner];
      weight.share = weight.area = area * part / total;
    }
  }
}

const std::map<int, NodalWeight>& NodalWeights::at(int node) const {
  static const std::map<int, NodalWeight> none;
  const auto found = weights_.find(node);
  return found == weights_.end() ? none : found->second;
}

NodalWeight NodalWeights::total(int node) const {
  NodalWeight sum;
  for (const auto& [piece, weight] : at(node)) {
    sum += weight;
  }
  return sum;
}

}  // namespace harmos::mesh
