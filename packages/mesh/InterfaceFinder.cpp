#include <harmos/mesh/InterfaceFinder.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/FaceMatching.hpp>
#include <harmos/mesh/Interpenetration.hpp>
#include <harmos/mesh/detail/FaceJoints.hpp>
#include <harmos/mesh/detail/FaceOverlap.hpp>
#include <harmos/mesh/detail/InnerFaces.hpp>
#include <harmos/mesh/detail/NodalWeights.hpp>
#include <harmos/mesh/detail/NodeJoints.hpp>
#include <harmos/mesh/detail/PartSkin.hpp>
#include <harmos/mesh/detail/PieceCuts.hpp>
#include <harmos/mesh/detail/SurfaceBuilders.hpp>

namespace harmos::mesh {
namespace {

// Area of a side set that may face the other way along a projection, over that of the rest.
constexpr double mostFolded = 1e-6;

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw base::Error(where + ": " + what, base::ExitCode::input);
}

std::string interfaceNamed(const std::string& name) {
  return "Interface \"" + name + "\"";
}

/// Up to which nodes lie on the axis of axisymmetry, where faces have no area; negative: there is none.
double radiusOfAxis(const CutMesh& parts) {
  if (!parts.depth.isRevolved()) return -1.0;
  double largest = 0.0;
  for (const base::Vector3& node : parts.mesh.nodes) largest = std::max(largest, std::abs(node[0]));
  return Depth::onAxis * largest;
}

std::string boundaryNamed(const std::string& name) {
  return "Boundary \"" + name + "\"";
}

std::string sideSetNamed(const std::string& name) {
  return "side set \"" + name + "\"";
}
std::string partNamed(const std::string& name) {
  return "part \"" + name + "\"";
}

template <typename Set>
const Set& findSet(const std::string& where, const std::vector<Set>& sets, const std::string& name, const char* kind) {
  std::vector<std::string> known;
  for (const Set& set : sets) {
    if (set.name == name) return set;
    known.push_back(set.name);
  }
  refuse(where, std::string("the mesh has no ") + kind + " \"" + name + "\". " +
                    base::suggestName(name, known, std::string(kind) + "s"));
}

}  // namespace

InterfaceFinder::InterfaceFinder(const Mesh& mesh, const std::vector<Piece>& pieces, const Depth& depth)
    : parts_(mesh, pieces, depth), skins_(std::make_shared<std::map<std::string, PartSkin>>()) {}

const PartSkin& InterfaceFinder::skinOf(const std::string& where, const std::string& part) const {
  const auto known = skins_->find(part);
  if (known != skins_->end()) return known->second;
  const std::vector<int> elements = parts_.map.elements(parts_.map.named(where, part));
  return skins_->try_emplace(part, parts_.mesh, skin(parts_.elements, elements)).first->second;
}

std::vector<Face> InterfaceFinder::facesOf(const std::string& where, const std::string& sideSet) const {
  const SideSet& set = findSet(where, parts_.mesh.sideSets, sideSet, "side set");
  if (set.element.empty()) {
    std::string unread;
    for (const std::string& block : parts_.mesh.unreadBlocks) unread += (unread.empty() ? "\"" : ", \"") + block + "\"";
    refuse(where, "side set \"" + sideSet + "\" is empty" +
                      (unread.empty() ? "." : "; faces of the unused blocks " + unread + " are left out."));
  }
  std::set<std::pair<int, int>> sides;  // a file may list a face twice
  for (std::size_t i = 0; i < set.element.size(); ++i) sides.emplace(set.element[i], set.side[i]);
  std::vector<Face> faces;
  for (const auto& [element, side] : sides) {
    if (parts_.map.of(element) < 0) {
      refuse(where, "side set \"" + sideSet + "\" has faces of block \"" +
                        parts_.mesh.blocks[parts_.elements.block(element)].name +
                        "\", which belongs to no part. Add a part with this block, or choose another side set.");
    }
    faces.push_back({element, side, parts_.elements.side(element, side)});
  }
  return faces;
}

std::vector<InterfaceSurface> InterfaceFinder::betweenSideSets(const std::string& name, const std::string& sideSet1,
                                                               const std::string& sideSet2,
                                                               const std::optional<base::Vector3>& direction,
                                                               double creaseAngle, const Joiner& join) const {
  const std::string where = interfaceNamed(name);
  const auto side1 = facesOf(where, sideSet1);
  const auto side2 = facesOf(where, sideSet2);
  std::optional<base::Vector3> projection;
  if (direction) {
    if (!(norm(*direction) > 0.0)) refuse(where, "Projection Direction has no length.");
    projection = (1.0 / norm(*direction)) * *direction;
    double outward = 0.0;
    double folded = 0.0;
    for (const Face& face : side1) {
      for (const NodalWeight& weight : parts_.integrate(face).weight) {
        const double along = dot(weight.normal, *projection);
        (along > 0.0 ? outward : folded) += along;
      }
    }
    if (outward + folded < 0.0) projection = -1.0 * *projection;
    if (std::min(outward, -folded) > mostFolded * std::max(outward, -folded)) {
      refuse(where, "side set \"" + sideSet1 +
                        "\" faces both ways along Projection Direction; restrict it to the faces that can touch.");
    }
  }
  const auto pairs = matchFaces(parts_.mesh, side1, side2, projection);
  if (pairs.size() == side1.size() && pairs.size() == side2.size()) {
    return joinFaces(parts_, name, side1, side2, pairs, creaseAngle, projection);
  }
  if (!projection && join) return join(sideSetNamed(sideSet1), side1, sideSetNamed(sideSet2), side2);
  const auto nodes1 = nodesOf(side1);
  const auto nodes2 = nodesOf(side2);
  const Separation apart = separation(parts_.mesh.nodes, nodes1, nodes2, projection);
  std::ostringstream message;
  message << "side sets \"" << sideSet1 << "\" (" << side1.size() << " faces, " << nodes1.size() << " nodes) and \""
          << sideSet2 << "\" (" << side2.size() << " faces, " << nodes2.size()
          << " nodes) do not conform: " << side1.size() - pairs.size() << " faces of the first and "
          << side2.size() - pairs.size()
          << " of the second have no partner with coinciding nodes and opposite normal on the other side. Seen "
          << (projection ? "along Projection Direction" : "in space") << ", a node of the first is between "
          << apart.smallest << " and " << apart.largest << " away from the nearest node of the second, farthest "
          << nodeName(parts_.mesh, apart.node) << "; the shortest edge there is "
          << localSizes(parts_.mesh, side1).at(apart.node)
          << " long. Mesh both sides with the same nodes and let both side "
          << "sets cover the same surface"
          << (projection ? ", or leave the direction out: then faces are joined that do not match."
                         : "; for sides that are open initially, give Projection Direction.");
  refuse(where, message.str());
}

std::vector<InterfaceSurface> InterfaceFinder::betweenParts(const std::string& name, const std::string& part1,
                                                            const std::string& part2, double creaseAngle,
                                                            const Joiner& join) const {
  const std::string where = interfaceNamed(name);
  const auto pieces1 = parts_.map.named(where, part1);
  const auto pieces2 = parts_.map.named(where, part2);
  if (part1 == part2) refuse(where, "Part 1 and Part 2 are both \"" + part1 + "\"; an interface joins two parts.");
  const PartSkin &all1 = skinOf(where, part1), &all2 = skinOf(where, part2);
  const std::vector<Face> skin1 = all1.near(all2), skin2 = all2.near(all1);
  const auto faces = matchFaces(parts_.mesh, skin1, skin2);
  const FaceOverlap overlap = findOverlap(parts_.mesh, skin1, skin2, faces);
  if (!overlap.faces1.empty() && join) {
    std::set<int> touching1(overlap.faces1.begin(), overlap.faces1.end());
    std::set<int> touching2(overlap.faces2.begin(), overlap.faces2.end());
    for (const FacePair& pair : faces) {
      touching1.insert(pair.face1);
      touching2.insert(pair.face2);
    }
    const auto chosen = [](const std::vector<Face>& all, const std::set<int>& which) {
      std::vector<Face> some;
      for (const int face : which) some.push_back(all[face]);
      return some;
    };
    return join(partNamed(part1), chosen(skin1, touching1), partNamed(part2), chosen(skin2, touching2));
  }
  if (faces.empty() && overlap.faces1.empty()) {
    demandNoOverlap(parts_.mesh, where, part1, all1.faces(), part2, all2.faces());
  }
  auto surfaces = joinFaces(parts_, name, skin1, skin2, faces, creaseAngle, std::nullopt);

  std::set<int> inFaces;
  for (const FacePair& pair : faces) {
    const auto& nodes = skin1[pair.face1].nodes;
    inFaces.insert(nodes.begin(), nodes.end());
  }
  std::set<std::pair<int, int>> single;
  for (const int node : sharedNodes(parts_, pieces1, pieces2)) {
    if (inFaces.count(node) == 0) single.emplace(node, node);
  }
  if (faces.empty()) {
    for (const auto& pair : matchNodes(parts_.mesh, skin1, skin2)) single.insert(pair);
  }
  if (!overlap.faces1.empty()) {
    const auto facesOf = [](std::size_t count, const std::string& part) {
      return std::to_string(count) + (count == 1 ? " face of part \"" : " faces of part \"") + part + "\"";
    };
    refuse(where, facesOf(overlap.faces1.size(), part1) + " and " + facesOf(overlap.faces2.size(), part2) +
                      " lie on each other, but do not match node by node, the first of them at " +
                      nodeName(parts_.mesh, skin1[overlap.faces1[0]].nodes[0]) + "; of the others " +
                      std::to_string(faces.size()) +
                      " of each part match. Mesh both parts with the same nodes where they touch.");
  }
  const auto more = joinNodes(parts_, name, pieces1, pieces2, {single.begin(), single.end()});
  surfaces.insert(surfaces.end(), more.begin(), more.end());
  if (surfaces.empty()) {
    std::ostringstream message;
    message
        << "parts \"" << part1 << "\" and \"" << part2
        << "\" have no coincident faces and no shared or coincident nodes; their nearest nodes are "
        << separation(parts_.mesh.nodes, nodesOf(all1.faces()), nodesOf(all2.faces())).smallest
        << " apart. Mesh both with the same nodes where they touch; for sides that are open initially, name two side "
           "sets, or give Search Distance.";
    refuse(where, message.str());
  }
  return surfaces;
}

std::vector<InterfaceSurface> InterfaceFinder::joinedSideSets(const std::string& name, const std::string& sideSet1,
                                                              const std::string& sideSet2, const Joiner& join) const {
  const std::string where = interfaceNamed(name);
  return join(sideSetNamed(sideSet1), facesOf(where, sideSet1), sideSetNamed(sideSet2), facesOf(where, sideSet2));
}

std::vector<InterfaceSurface> InterfaceFinder::joinedParts(const std::string& name, const std::string& part1,
                                                           const std::string& part2, const Joiner& join) const {
  const std::string where = interfaceNamed(name);
  return join(partNamed(part1), skinOf(where, part1).faces(), partNamed(part2), skinOf(where, part2).faces());
}

std::vector<InterfaceSurface> InterfaceFinder::cuts() const {
  return pieceCuts(parts_);
}

std::vector<InterfaceSurface> InterfaceFinder::onFaces(const std::string& name, const std::vector<Face>& faces,
                                                       double creaseAngle) const {
  SurfaceBuilders builders(parts_.mesh, parts_.pieces, creaseAngle);
  const double axis = radiusOfAxis(parts_);
  for (const Face& face : faces) {
    const auto isOnAxis = [&](int node) { return std::abs(parts_.mesh.nodes[node][0]) <= axis; };
    if (std::all_of(face.nodes.begin(), face.nodes.end(), isOnAxis)) continue;
    builders.addFace(parts_.map.of(face.element), -1, face.nodes, {}, parts_.integrate(face));
  }
  return builders.build(name);
}

std::vector<InterfaceSurface> InterfaceFinder::onSideSet(const std::string& name, const std::string& sideSet,
                                                         double creaseAngle) const {
  return onFaces(name, facesOf(boundaryNamed(name), sideSet), creaseAngle);
}

std::vector<InterfaceSurface> InterfaceFinder::onNodeSet(const std::string& name, const std::string& nodeSet,
                                                         const std::string& part, double creaseAngle) const {
  const std::string where = boundaryNamed(name);
  const NodeSet& set = findSet(where, parts_.mesh.nodeSets, nodeSet, "node set");
  if (set.node.empty()) refuse(where, "node set \"" + nodeSet + "\" is empty.");
  std::vector<int> pieces(parts_.map.count());
  std::iota(pieces.begin(), pieces.end(), 0);
  if (!part.empty()) pieces = parts_.map.named(where, part);
  std::set<int> nodes;
  for (const int node : set.node) {
    if (std::any_of(pieces.begin(), pieces.end(), [&](int piece) { return parts_.map.has(piece, node); })) {
      nodes.insert(node);
    } else if (part.empty()) {
      refuse(where, "node set \"" + nodeSet + "\" has " + nodeName(parts_.mesh, node) +
                        ", which belongs to no part. Add a part with its block, or choose another node set.");
    }
  }
  if (nodes.empty()) refuse(where, "node set \"" + nodeSet + "\" has no node of part \"" + part + "\".");

  std::vector<Face> faces;
  for (Face& face : skinAt(parts_.elements, parts_.map.elements(pieces), {nodes.begin(), nodes.end()})) {
    if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return nodes.count(node) > 0; })) {
      faces.push_back(std::move(face));
    }
  }
  if (nodesOf(faces).size() == nodes.size()) return onFaces(name, faces, creaseAngle);

  const NodalWeights weights(parts_.mesh, parts_.elements, parts_.map, pieces, {nodes.begin(), nodes.end()},
                             parts_.depth);
  SurfaceBuilders builders(parts_.mesh, parts_.pieces, oneNormal);
  const double axis = radiusOfAxis(parts_);
  for (const int node : nodes) {
    for (const auto& [piece, weight] : weights.at(node)) {
      if (std::abs(parts_.mesh.nodes[node][0]) <= axis && weight.area == 0.0) continue;
      builders.addNode(piece, -1, node, -1, weight);
    }
  }
  return builders.build(name);
}

void InterfaceFinder::demandSurface(const std::string& where, const std::string& sideSet) const {
  const auto faces = facesOf(where, sideSet);
  const auto inner = innerFaces(parts_.mesh, parts_.elements, parts_.map, faces);
  if (inner.empty()) return;
  refuse(where, std::to_string(inner.size()) + " of the " + std::to_string(faces.size()) + " faces of side set \"" +
                    sideSet + "\" lie inside of part \"" + parts_.map.part(parts_.map.of(inner[0].element)) +
                    "\", the first of them of " + elementName(parts_.mesh, inner[0].element) +
                    ". A law acts on the surface of a part: divide the part there into two blocks, or choose another "
                    "side set.");
}

}  // namespace harmos::mesh
