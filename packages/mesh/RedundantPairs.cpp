#include <harmos/mesh/RedundantPairs.hpp>

#include <algorithm>
#include <map>
#include <tuple>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/InterfaceFrame.hpp>
#include <harmos/mesh/NodalWeight.hpp>

namespace harmos::mesh {
namespace {

using Carriers = std::vector<std::vector<PairCarrier>>;

const Piece& at(const std::vector<Piece>& pieces, int piece) {
  return pieces[piece];
}

bool isCut(const std::vector<Piece>& pieces, const InterfaceSurface& surface) {
  return surface.piece2 >= 0 && at(pieces, surface.piece1).part == at(pieces, surface.piece2).part;
}

/// Points that feel several nodes have no copies but those that say so.
bool isOfNodes(const InterfaceSurface& surface) {
  return surface.point.empty() && surface.trace1.isSelection() && surface.trace2.isSelection();
}

int meshNode(const std::vector<Piece>& pieces, int piece, int node) {
  return at(pieces, piece).nodes[node];
}

double& areaOf(std::vector<InterfaceSurface>& surfaces, const PairCarrier& pair) {
  return surfaces[pair.surface].area[pair.pair];
}

/// What makes pairs copies of each other: bodies may share mesh nodes as well, but not their displacements.
struct Place {
  std::string interface, body1, body2;
  int meshNode1, meshNode2, patch;  // where meshes do not match, the number of the point instead of the first
  bool operator<(const Place& other) const {
    return std::tie(interface, body1, body2, meshNode1, meshNode2, patch) <
           std::tie(other.interface, other.body1, other.body2, other.meshNode1, other.meshNode2, other.patch);
  }
};

/// All pairs of one interface that join the same nodes of the same bodies in the same patch have one carrier.
void mergeCopies(const std::vector<Piece>& pieces, int dimension, std::vector<InterfaceSurface>& surfaces,
                 Carriers& carriers) {
  std::map<Place, std::vector<PairCarrier>> copies;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const InterfaceSurface& surface = surfaces[s];
    if (isCut(pieces, surface) || (!isOfNodes(surface) && surface.point.empty())) continue;
    const bool hasTwoSides = surface.piece2 >= 0;
    Place place{
        surface.name, at(pieces, surface.piece1).part, hasTwoSides ? at(pieces, surface.piece2).part : "", -1, -1, 0};
    for (int p = 0; p < surface.pairs(); ++p) {
      if (!surface.point.empty()) {
        place.meshNode1 = surface.point[p];
        copies[place].push_back({static_cast<int>(s), p});
        continue;
      }
      place.meshNode1 = meshNode(pieces, surface.piece1, surface.trace1.node(p));
      place.patch = surface.patch[p];
      if (hasTwoSides) place.meshNode2 = meshNode(pieces, surface.piece2, surface.trace2.node(p));
      copies[place].push_back({static_cast<int>(s), p});
    }
  }
  for (const auto& [key, pairs] : copies) {
    const PairCarrier carrier = *std::max_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
      return areaOf(surfaces, a) < areaOf(surfaces, b);
    });
    for (const PairCarrier& pair : pairs) carriers[pair.surface][pair.pair] = carrier;
    if (pairs.size() == 1) continue;
    NodalWeight total;
    for (const auto& [copy, pair] : pairs) {
      const InterfaceSurface& surface = surfaces[copy];
      total += {surface.share[pair], surface.flux[pair], surface.area[pair], surface.normal[pair]};
    }
    InterfaceSurface& surface = surfaces[carrier.surface];
    surface.share[carrier.pair] = total.share;
    surface.flux[carrier.pair] = total.flux;
    surface.area[carrier.pair] = total.area;
    surface.normal[carrier.pair] = total.normal;
    surface.frame[carrier.pair] = frameFromNormal(total.normal, dimension);
  }
}

/// Of the pairs between the pieces at a mesh node, those of a spanning tree carry themselves, the others nothing.
void keepSpanningTrees(const std::vector<Piece>& pieces, std::vector<InterfaceSurface>& surfaces, Carriers& carriers) {
  std::map<int, std::vector<PairCarrier>> links;  // by mesh node
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!isCut(pieces, surfaces[s])) continue;
    for (int p = 0; p < surfaces[s].pairs(); ++p) {
      links[meshNode(pieces, surfaces[s].piece1, surfaces[s].trace1.node(p))].push_back({static_cast<int>(s), p});
    }
  }
  for (auto& [node, pairs] : links) {
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const auto& a, const auto& b) { return areaOf(surfaces, a) > areaOf(surfaces, b); });
    std::map<int, int> tied;  // piece -> a piece that stands for all tied to it
    const auto representative = [&](int piece) {
      tied.emplace(piece, piece);
      while (tied[piece] != piece) piece = tied[piece];
      return piece;
    };
    for (const PairCarrier& pair : pairs) {
      const InterfaceSurface& surface = surfaces[pair.surface];
      const int first = representative(surface.piece1);
      const int second = representative(surface.piece2);
      if (first == second) continue;
      tied[first] = second;
      carriers[pair.surface][pair.pair] = pair;
    }
  }
}

}  // namespace

Carriers mergeRedundantPairs(const std::vector<Piece>& pieces, int dimension, std::vector<InterfaceSurface>& surfaces) {
  Carriers carriers;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    carriers.emplace_back(static_cast<std::size_t>(surfaces[s].pairs()));
    if (isOfNodes(surfaces[s])) continue;
    for (int p = 0; p < surfaces[s].pairs(); ++p) carriers[s][p] = {static_cast<int>(s), p};
  }
  mergeCopies(pieces, dimension, surfaces, carriers);
  keepSpanningTrees(pieces, surfaces, carriers);
  return carriers;
}

}  // namespace harmos::mesh
