#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/scene/detail/AxisBoundaries.hpp>

namespace harmos::scene {
namespace {

/// The nodes of a boundary that no surface has.
std::set<int> nodesLeftOut(const input::Parameters& boundary, const mesh::Mesh& mesh,
                           const std::vector<mesh::Piece>& pieces, const mesh::InterfaceFinder& finder,
                           const std::vector<mesh::InterfaceSurface>& surfaces) {
  std::set<int> nodes;
  if (boundary.has("Side Set")) {
    for (const mesh::Face& face : finder.facesOf(base::quoted(boundary.name()), boundary.text("Side Set")))
      nodes.insert(face.nodes.begin(), face.nodes.end());
  } else if (boundary.has("Node Set")) {
    for (const mesh::NodeSet& set : mesh.nodeSets) {
      if (set.name == boundary.text("Node Set")) nodes.insert(set.node.begin(), set.node.end());
    }
  }
  if (boundary.has("Part")) {
    std::set<int> ofPart;
    for (const mesh::Piece& piece : pieces) {
      if (piece.part == boundary.text("Part")) ofPart.insert(piece.nodes.begin(), piece.nodes.end());
    }
    for (auto node = nodes.begin(); node != nodes.end();)
      node = ofPart.count(*node) > 0 ? std::next(node) : nodes.erase(node);
  }
  for (const mesh::InterfaceSurface& surface : surfaces) {
    for (int p = 0; p < surface.pairs(); ++p) nodes.erase(pieces[surface.piece1].nodes[surface.trace1.node(p)]);
  }
  return nodes;
}

}  // namespace

void demandNothingAlongAxis(const input::Parameters& boundary, const laws::InterfaceLaw& law, int steps,
                            const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                            const mesh::InterfaceFinder& finder, const std::vector<mesh::InterfaceSurface>& surfaces) {
  if (!law.isAffine() || law.prescribesTraction()) return;
  const std::set<int> nodes = nodesLeftOut(boundary, mesh, pieces, finder, surfaces);
  if (nodes.empty()) return;
  for (int t = 0; t < steps; ++t) {
    const auto components = laws::affineComponents(law, t);
    const auto isRigid = [&](std::size_t c) { return std::isinf(components[c].stiffness); };
    const bool moves = (isRigid(0) && components[0].offset != 0.0) || (isRigid(2) && components[2].offset != 0.0);
    if (!moves && !isRigid(1)) continue;
    std::ostringstream message;
    message << (moves ? "moves" : "holds along the axis") << " nodes on the axis of axisymmetry, the lowest at y = ";
    double lowest = mesh.nodes[*nodes.begin()][1];
    for (const int node : nodes) lowest = std::min(lowest, mesh.nodes[node][1]);
    message << lowest << ", where faces have no area.\n  They stay on the axis by themselves: "
            << (moves ? "leave out what moves them off it or around it."
                      : "leave out Y, and hold or load the part along the axis at faces that have an area.");
    throw base::Error(message.str(), base::ExitCode::input);
  }
}

}  // namespace harmos::scene
