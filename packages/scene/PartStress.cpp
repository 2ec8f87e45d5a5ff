#include <harmos/scene/detail/PartStress.hpp>

#include <algorithm>
#include <numeric>

#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Skin.hpp>
#include <harmos/recovery/StressRecovery.hpp>

namespace harmos::scene {
namespace {

// Of a node: in the plane patches are smaller; quadratic simplices take many elements and ten monomials.
constexpr double workInPlane = 0.3, workOfQuadraticSimplex = 4.0;

/// Nodes and elements of a piece, in their order, without sets.
mesh::Mesh meshOf(const mesh::Mesh& mesh, const mesh::Piece& piece) {
  mesh::Mesh result;
  result.dimension = mesh.dimension;
  result.nodes = mesh::pointsOf(mesh, piece.nodes);
  const mesh::Elements elements(mesh);
  int last = -1;
  for (const int element : piece.elements) {
    const int block = elements.block(element);
    if (block != last) {
      result.blocks.push_back({mesh.blocks[block].name, mesh.blocks[block].id, mesh.blocks[block].type, {}});
      last = block;
    }
    const int* nodes = elements.nodes(element);
    for (int a = 0; a < mesh::nodesPerElement(elements.type(element)); ++a) {
      result.blocks.back().connectivity.push_back(mesh::localNode(piece, nodes[a]));
    }
  }
  return result;
}

}  // namespace

std::vector<PartStress> PartStress::ofAll(const mesh::Mesh& mesh, const Bodies& bodies, const Model& model,
                                          const Temperatures& temperatures) {
  std::vector<PartStress> result;
  for (PartPieces& part : partPieces(mesh, bodies.pieces)) {
    result.push_back(PartStress(mesh, bodies, model, temperatures, std::move(part)));
  }
  return result;
}

PartStress::PartStress(const mesh::Mesh& mesh, const Bodies& bodies, const Model& model,
                       const Temperatures& temperatures, PartPieces part)
    : mesh_(meshOf(mesh, part.piece)),
      part_(std::move(part)),
      model_(model),
      temperature_(temperatures.of(part_.piece)) {
  for (const int body : part_.bodies) {
    std::vector<int>& nodes = nodeOfPart_.emplace_back();
    for (const int node : bodies.pieces[body].nodes) nodes.push_back(mesh::localNode(part_.piece, node));
  }
  const auto body = static_cast<std::size_t>(part_.bodies.front());
  material_ = bodies.materials[body];
  formulation_ = bodies.parts[body].formulation;
  std::vector<int> elements(part_.piece.elements.size());
  std::iota(elements.begin(), elements.end(), 0);
  part_.piece = mesh::makePiece(mesh_, part_.name, part_.name, std::move(elements));
  boundary_.assign(mesh_.nodes.size(), false);
  for (const mesh::Face& face : mesh::skin(mesh::Elements(mesh_), part_.piece.elements)) {
    for (const int node : face.nodes) boundary_[node] = true;
  }
}

latin::ResponseWork PartStress::work() const {
  latin::ResponseWork work;
  const auto isQuadraticSimplex = [](const mesh::ElementBlock& block) {
    return block.type == mesh::ElementType::tet10;
  };
  const auto nodes = static_cast<double>(mesh_.nodes.size());
  const bool isDear = std::any_of(mesh_.blocks.begin(), mesh_.blocks.end(), isQuadraticSimplex);
  work.recovered = nodes * (mesh_.dimension == 2 ? workInPlane : isDear ? workOfQuadraticSimplex : 1.0);
  work.together = nodes;
  return work;
}

base::Matrix PartStress::recover(const latin::Iterate& state, int first, int count) const {
  const int components = elasticity::componentsOf(model_.kinematics),
            dofs = components * static_cast<int>(mesh_.nodes.size());
  base::Matrix displacements(dofs, count);
  std::vector<double> sharing(mesh_.nodes.size(), 0.0);  // bodies that have the node
  for (std::size_t i = 0; i < part_.bodies.size(); ++i) {
    for (const int node : nodeOfPart_[i]) sharing[node] += 1.0;
  }
  for (std::size_t i = 0; i < part_.bodies.size(); ++i) {
    const int body = part_.bodies[i];
    if (!state.layout().owns(body)) continue;
    for (int j = 0; j < count; ++j) {
      for (int node = 0; node < static_cast<int>(nodeOfPart_[i].size()); ++node) {
        const int to = nodeOfPart_[i][node];
        const base::Vector3 u = strainingDisplacement(state, part_, body, node, first + j);
        for (int c = 0; c < components; ++c) displacements(components * to + c, j) += u[c] / sharing[to];
      }
    }
  }
  if (part_.bodies.size() > 1) {
    std::vector<double> values(displacements.values(), displacements.values() + dofs * count);
    state.metric().sum(values);
    displacements = base::Matrix(Teuchos::Copy, values.data(), dofs, dofs, count);
  }
  if (!state.layout().owns(part_.bodies.front())) return {};
  base::Matrix temperature;
  if (temperature_.numRows() > 0) {
    temperature = base::Matrix(Teuchos::Copy, temperature_, temperature_.numRows(), count, 0, first);
  }
  const elasticity::ElasticPart elastic{mesh_,
                                        part_.piece,
                                        *material_,
                                        formulation_,
                                        model_.kinematics,
                                        model_.thickness,
                                        temperature.numRows() > 0 ? &temperature : nullptr};
  const recovery::StressRecovery recovered(elastic, boundary_, displacements);
  base::Matrix result(6 * static_cast<int>(mesh_.nodes.size()), count);
  for (int node = 0; node < recovered.stress().numCols(); ++node) {
    for (int m = 0; m < 6; ++m) {
      for (int j = 0; j < count; ++j) result(6 * node + m, j) = recovered.stress()(m * count + j, node);
    }
  }
  return result;
}

}  // namespace harmos::scene
