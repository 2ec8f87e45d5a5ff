#include <harmos/mesh/RedundantPairs.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace harmos::mesh {
namespace {

using Carriers = std::vector<std::vector<PairCarrier>>;

const Part& at(const std::vector<Part>& parts, int part) {
  return parts[part];
}

bool isCut(const std::vector<Part>& parts, const InterfaceSurface& surface) {
  return surface.part2 >= 0 && at(parts, surface.part1).body == at(parts, surface.part2).body;
}

int meshNode(const std::vector<Part>& parts, int part, int node) {
  return at(parts, part).nodes[node];
}

double& areaOf(std::vector<InterfaceSurface>& surfaces, const PairCarrier& pair) {
  return surfaces[pair.surface].area[pair.pair];
}

/// What makes pairs copies of each other: bodies may share mesh nodes as well, but not their displacements.
struct Place {
  std::string interface, body1, body2;
  int meshNode1, meshNode2;
  bool operator<(const Place& other) const {
    return std::tie(interface, body1, body2, meshNode1, meshNode2) <
           std::tie(other.interface, other.body1, other.body2, other.meshNode1, other.meshNode2);
  }
};

/// All pairs of one interface that join the same nodes of the same bodies have one carrier.
void mergeCopies(const std::vector<Part>& parts, std::vector<InterfaceSurface>& surfaces, Carriers& carriers) {
  std::map<Place, std::vector<PairCarrier>> copies;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const InterfaceSurface& surface = surfaces[s];
    if (isCut(parts, surface)) continue;
    const bool hasTwoSides = surface.part2 >= 0;
    Place place{surface.name, at(parts, surface.part1).body, hasTwoSides ? at(parts, surface.part2).body : "", -1, -1};
    for (std::size_t p = 0; p < surface.node1.size(); ++p) {
      place.meshNode1 = meshNode(parts, surface.part1, surface.node1[p]);
      if (hasTwoSides) place.meshNode2 = meshNode(parts, surface.part2, surface.node2[p]);
      copies[place].push_back({static_cast<int>(s), static_cast<int>(p)});
    }
  }
  for (const auto& [key, pairs] : copies) {
    const PairCarrier carrier = *std::max_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
      return areaOf(surfaces, a) < areaOf(surfaces, b);
    });
    double total = 0.0;
    for (const PairCarrier& pair : pairs) {
      total += areaOf(surfaces, pair);
      carriers[pair.surface][pair.pair] = carrier;
    }
    areaOf(surfaces, carrier) = total;
  }
}

/// Of the pairs between the pieces at a mesh node, those of a spanning tree carry themselves, the others nothing.
void keepSpanningTrees(const std::vector<Part>& parts, std::vector<InterfaceSurface>& surfaces, Carriers& carriers) {
  std::map<int, std::vector<PairCarrier>> links;  // by mesh node
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (!isCut(parts, surfaces[s])) continue;
    for (std::size_t p = 0; p < surfaces[s].node1.size(); ++p) {
      links[meshNode(parts, surfaces[s].part1, surfaces[s].node1[p])].push_back(
          {static_cast<int>(s), static_cast<int>(p)});
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
      const int first = representative(surface.part1);
      const int second = representative(surface.part2);
      if (first == second) continue;
      tied[first] = second;
      carriers[pair.surface][pair.pair] = pair;
    }
  }
}

}  // namespace

Carriers mergeRedundantPairs(const std::vector<Part>& parts, std::vector<InterfaceSurface>& surfaces) {
  Carriers carriers;
  for (const InterfaceSurface& surface : surfaces) carriers.emplace_back(surface.node1.size());
  mergeCopies(parts, surfaces, carriers);
  keepSpanningTrees(parts, surfaces, carriers);
  return carriers;
}

}  // namespace harmos::mesh
