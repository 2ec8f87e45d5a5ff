#include <harmos/scene/detail/MeasuredPart.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <harmos/elasticity/Material.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/scene/detail/SharedOperators.hpp>
#include <harmos/scene/detail/TouchedUnknowns.hpp>
#include <harmos/substructure/MirrorPlanes.hpp>

namespace harmos::scene {
namespace {

/// Nodes that share elements, as compressed rows, each node with itself.
struct NodeGraph {
  std::vector<std::size_t> first{0};
  std::vector<int> columns;
};

NodeGraph graphOf(const mesh::Elements& elements, const mesh::Piece& piece) {
  std::vector<std::vector<int>> near(piece.nodes.size());
  for (const int element : piece.elements) {
    std::vector<int> own;
    const int* nodes = elements.nodes(element);
    for (int a = 0; a < mesh::nodesPerElement(elements.type(element)); ++a)
      own.push_back(mesh::localNode(piece, nodes[a]));
    for (const int node : own) near[node].insert(near[node].end(), own.begin(), own.end());
  }
  NodeGraph graph;
  for (std::vector<int>& row : near) {
    std::sort(row.begin(), row.end());
    graph.columns.insert(graph.columns.end(), row.begin(), std::unique(row.begin(), row.end()));
    graph.first.push_back(graph.columns.size());
  }
  return graph;
}

/// Stiffness and factor from the neighbours of nodes.
void measure(const NodeGraph& graph, int dimension, BodySize& size) {
  const double components = dimension;
  size.matrixEntries = components * components * static_cast<double>(graph.columns.size());
  size.factor =
      substructure::NestedDissection(static_cast<int>(graph.first.size()) - 1, graph.first.data(), graph.columns.data())
          .factorSize();
  size.factor.nonzeros *= components * components;
  size.factor.operations *= components * components * components;
  size.factor.bytes *= components * components;
}

/// Components c, d of displacement that a material couples where it is not its own mirror image across one of them: the
/// largest |C_ij| / sqrt(C_ii C_jj) whose strains i and j change their signs unlike across c and d, and 1 on the
/// diagonal. In the plane without the shears across it.
std::array<std::array<double, 3>, 3> couplingOf(const elasticity::ElasticityMatrix& elasticity, int dimension) {
  constexpr int turned[] = {0, 0, 0, 0b011, 0b110, 0b101};  // strains change their signs across these axes
  const std::size_t strains = dimension == 2 ? 4 : 6;
  std::array<std::array<double, 3>, 3> coupling{};
  for (std::size_t c = 0; c < 3; ++c) {
    coupling[c][c] = 1.0;
    for (std::size_t d = 0; d < c; ++d) {
      for (std::size_t i = 0; i < strains; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if ((turned[i] ^ turned[j]) != (1 << c | 1 << d)) continue;
          const double size = std::sqrt(elasticity[i][i] * elasticity[j][j]);
          coupling[c][d] = coupling[d][c] = std::max(coupling[c][d], std::abs(elasticity[i][j]) / size);
        }
      }
    }
  }
  return coupling;
}

/// The factors of a body that is cut by the mirror planes of its nodes, their neighbours, its material, its trace and
/// what holds it.
substructure::FactorSize mirrored(const substructure::FactorSize& plain, const std::vector<base::Vector3>& nodes,
                                  const NodeGraph& graph, int dimension, const elasticity::ElasticityMatrix& elasticity,
                                  const std::vector<int>& trace, const std::vector<int>& held) {
  substructure::MirrorPlanes planes(nodes, dimension);
  planes.keepThoseOf(trace);
  planes.keepThoseOf(held);
  // A matrix with the same planes: neighbours are alike in the first components, a node by itself as the material.
  const auto coupling = couplingOf(elasticity, dimension);
  std::vector<std::size_t> pointers{0};
  std::vector<int> columns;
  std::vector<double> values;
  const auto add = [&](int column, double value) {
    columns.push_back(column);
    values.push_back(value);
  };
  for (int node = 0; node < static_cast<int>(nodes.size()); ++node) {
    for (int c = 0; c < dimension; ++c) {
      for (std::size_t k = graph.first[node]; k < graph.first[node + 1]; ++k) {
        if (graph.columns[k] != node) {
          if (c == 0) add(graph.columns[k] * dimension, 1.0);
          continue;
        }
        for (int d = 0; d < dimension; ++d) add(node * dimension + d, coupling[c][d]);
      }
      pointers.push_back(columns.size());
    }
  }
  planes.keepThoseOf({static_cast<int>(pointers.size()) - 1, pointers.data(), columns.data(), values.data()});
  substructure::FactorSize size = plain;
  size.blocks = 1 << planes.count();
  const double entries = std::pow(size.blocks, 1.0 - growthOfEntries[dimension - 2]);
  size.nonzeros *= entries;
  size.bytes *= entries;
  size.operations *= std::pow(size.blocks, 1.0 - growthOfOperations[dimension - 2]);
  return size;
}

}  // namespace

std::vector<MeasuredPart> measureParts(const Scene& scene, const mesh::Mesh& mesh, const Bodies& bodies,
                                       const std::vector<assembly::Interface>& interfaces, int dimension) {
  std::vector<std::vector<int>> trace, held;
  for (std::size_t b = 0; b < bodies.pieces.size(); ++b) {
    trace.push_back(traceOf(interfaces, b, dimension));
    held.push_back(heldOf(interfaces, b, dimension));
  }
  const std::vector<double> touching = interfacesOf(interfaces, bodies.pieces.size());
  std::set<std::string> given, solverGiven;
  for (const input::Parameters& part : scene.input.lists("Parts")) {
    if (part.has("Pieces")) given.insert(part.name());
    if (part.has("Linear Solver")) solverGiven.insert(part.name());
  }
  const mesh::Elements elements(mesh);
  const auto congruences =
      findCongruences(bodies, mesh, makeModel(scene.input.list("Model"), mesh).kinematics, interfaces);
  std::map<std::size_t, substructure::FactorSize> plainFactors;  // by the first of equal bodies
  SharedOperators operators(interfaces, dimension);
  std::vector<MeasuredPart> all;
  for (std::size_t b = 0; b < bodies.pieces.size(); ++b) {
    const mesh::Piece& piece = bodies.pieces[b];
    MeasuredPart& body = all.emplace_back();
    body.part = piece.part;
    body.nodes = static_cast<double>(piece.nodes.size());
    body.size.unknowns = dimension * body.nodes;
    body.size.trace = static_cast<double>(trace[b].size());
    body.size.interfaces = touching[b];
    const bool isLarge = body.size.unknowns >= leastUnknowns;
    body.mayIterate = isLarge && solverGiven.count(piece.part) == 0;
    body.isOpen = isLarge && piece.side == 0 && given.count(piece.part) == 0 && !bodies.parts[b].iterates;
    if (bodies.parts[b].iterates) {
      body.size.iteratedEntries = operatorEntries(body.size.unknowns, dimension);
      continue;
    }
    const substructure::Congruence* congruence = congruences[b].get();
    const std::size_t master = congruence ? static_cast<std::size_t>(congruence->representative) : b;
    const auto [plain, isFirst] = plainFactors.try_emplace(master, factorOf(body.size.unknowns, dimension));
    if (isFirst) body.size.matrixEntries = operatorEntries(body.size.unknowns, dimension);
    body.size.factor = body.plain = plain->second;
    const std::size_t same = operators.add(b, piece.nodes.size(), congruence, false);
    body.size.isFactored = same == b;
    if (!body.size.isFactored) body.size.factor = all[same].size.factor;
    if (!isLarge || !body.size.isFactored) continue;
    const NodeGraph graph = graphOf(elements, piece);
    if (isFirst) {
      measure(graph, dimension, body.size);
      body.plain = plain->second = body.size.factor;
    }
    std::vector<base::Vector3> nodes;
    for (const int node : piece.nodes) nodes.push_back(mesh.nodes[node]);
    body.size.factor =
        mirrored(body.plain, nodes, graph, dimension, bodies.materials[b]->elasticity(), trace[b], held[b]);
  }
  return all;
}

}  // namespace harmos::scene
