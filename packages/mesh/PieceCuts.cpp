#include <harmos/mesh/detail/PieceCuts.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <harmos/mesh/detail/NodeJoints.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {
namespace {

std::vector<InterfaceSurface> cutsOf(const CutMesh& parts, const std::string& name, const std::vector<int>& pieces) {
  SurfaceBuilders builders(parts.mesh, parts.pieces, noCrease);
  std::map<std::vector<int>, Face> open;           // by sorted nodes: faces whose other side has not come yet
  std::map<int, std::vector<std::set<int>>> tied;  // per node: groups of pieces that faces join there
  for (const int piece : pieces) {
    for (const int node : parts.pieces[piece].nodes) tied[node].push_back({piece});
  }
  for (const int piece : pieces) {
    for (Face& face : skin(parts.elements, parts.pieces[piece].elements)) {
      std::vector<int> key = face.nodes;
      std::sort(key.begin(), key.end());
      const auto other = open.find(key);
      if (other == open.end()) {
        open.emplace(std::move(key), std::move(face));
        continue;
      }
      const Face& first = other->second;
      const int firstPiece = parts.map.of(first.element);
      builders.addFace(firstPiece, piece, first.nodes, first.nodes, parts.integrate(first));
      for (const int node : first.nodes) {
        auto& groups = tied[node];
        const auto holds = [](int wanted) { return [wanted](const std::set<int>& g) { return g.count(wanted) > 0; }; };
        const auto a = std::find_if(groups.begin(), groups.end(), holds(firstPiece));
        const auto b = std::find_if(groups.begin(), groups.end(), holds(piece));
        if (a == b) continue;
        a->insert(b->begin(), b->end());
        groups.erase(b);
      }
      open.erase(other);
    }
  }
  auto surfaces = builders.build(name);
  // Pieces that touch in an edge or a point only, with no chain of faces around the node, are tied there.
  std::map<std::pair<int, int>, std::vector<std::pair<int, int>>> single;
  for (const auto& [node, groups] : tied) {
    for (std::size_t i = 1; i < groups.size(); ++i) {
      const auto ends = std::minmax(*groups[0].begin(), *groups[i].begin());
      single[{ends.first, ends.second}].emplace_back(node, node);
    }
  }
  for (const auto& [ends, nodes] : single) {
    const auto more = joinNodes(parts, name, {ends.first}, {ends.second}, nodes);
    surfaces.insert(surfaces.end(), more.begin(), more.end());
  }
  return surfaces;
}

}  // namespace

std::vector<InterfaceSurface> pieceCuts(const CutMesh& parts) {
  std::map<std::string, std::vector<int>> piecesOf;
  for (int piece = 0; piece < parts.map.count(); ++piece) piecesOf[parts.map.part(piece)].push_back(piece);
  std::vector<InterfaceSurface> surfaces;
  for (const auto& [part, pieces] : piecesOf) {
    if (pieces.size() < 2) continue;
    const auto more = cutsOf(parts, part + " cut", pieces);
    surfaces.insert(surfaces.end(), more.begin(), more.end());
  }
  return surfaces;
}

}  // namespace harmos::mesh
