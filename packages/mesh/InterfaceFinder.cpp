#include <harmos/mesh/InterfaceFinder.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/Interpenetration.hpp>
#include <harmos/mesh/detail/FaceOverlap.hpp>
#include <harmos/mesh/detail/InnerFaces.hpp>
#include <harmos/mesh/detail/NodalWeights.hpp>
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
std::string boundaryNamed(const std::string& name) {
  return "Boundary \"" + name + "\"";
}

std::string sideSetNamed(const std::string& name) {
  return "side set \"" + name + "\"";
}
std::string partNamed(const std::string& name) {
  return "part \"" + name + "\"";
}

std::string text(const base::Vector3& p) {
  std::ostringstream out;
  out << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return out.str();
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

/// Refuses parts of which one reaches into the other.
void demandNoOverlap(const Mesh& mesh, const std::string& where, const std::string& part1,
                     const std::vector<Face>& skin1, const std::string& part2, const std::vector<Face>& skin2) {
  const Interpenetration first = interpenetration(mesh, skin1, skin2), second = interpenetration(mesh, skin2, skin1);
  const bool isFirst = first.depth >= second.depth;
  const Interpenetration& worse = isFirst ? first : second;
  if (worse.element < 0) return;
  std::ostringstream message;
  message << "parts \"" << part1 << "\" and \"" << part2 << "\" overlap: " << worse.elements
          << (worse.elements == 1 ? " element" : " elements") << " at the surface of part \""
          << (isFirst ? part1 : part2) << "\" " << (worse.elements == 1 ? "reaches" : "reach") << " into part \""
          << (isFirst ? part2 : part1) << "\", farthest element " << worse.element + 1 << " of the mesh, by "
          << worse.depth << " at " << text(worse.place)
          << ". Move or mesh them so that they touch; for an interference, name the sides that touch by side sets.";
  refuse(where, message.str());
}

}  // namespace

InterfaceFinder::InterfaceFinder(const Mesh& mesh, const std::vector<Piece>& pieces, const Depth& depth)
    : mesh_(mesh),
      pieces_(pieces),
      depth_(mesh.dimension == 2 ? depth : Depth()),
      elements_(mesh),
      map_(mesh, elements_, pieces) {}

std::vector<Face> InterfaceFinder::facesOf(const std::string& where, const std::string& sideSet) const {
  const SideSet& set = findSet(where, mesh_.sideSets, sideSet, "side set");
  if (set.element.empty()) {
    std::string unread;
    for (const std::string& block : mesh_.unreadBlocks) unread += (unread.empty() ? "\"" : ", \"") + block + "\"";
    refuse(where, "side set \"" + sideSet + "\" is empty" +
                      (unread.empty() ? "." : "; faces of the unused blocks " + unread + " are left out."));
  }
  std::set<std::pair<int, int>> sides;  // a file may list a face twice
  for (std::size_t i = 0; i < set.element.size(); ++i) sides.emplace(set.element[i], set.side[i]);
  std::vector<Face> faces;
  for (const auto& [element, side] : sides) {
    if (map_.of(element) < 0) {
      refuse(where, "side set \"" + sideSet + "\" has faces of block \"" + mesh_.blocks[elements_.block(element)].name +
                        "\", which belongs to no part. Add a part with this block, or choose another side set.");
    }
    faces.push_back({element, side, elements_.side(element, side)});
  }
  return faces;
}

FaceIntegrals InterfaceFinder::integrate(const Face& face, const std::optional<base::Vector3>& projection) const {
  return integrateFace(mesh_.dimension, pointsOf(mesh_, face.nodes), depth_, projection);
}

std::vector<InterfaceSurface> InterfaceFinder::joinPairs(const std::string& name, const std::vector<Face>& side1,
                                                         const std::vector<Face>& side2,
                                                         const std::vector<FacePair>& pairs, double creaseAngle,
                                                         const std::optional<base::Vector3>& projection) const {
  SurfaceBuilders builders(mesh_, pieces_, creaseAngle, projection);
  for (const FacePair& pair : pairs) {
    const Face& face1 = side1[pair.face1];
    const Face& face2 = side2[pair.face2];
    const int piece1 = map_.of(face1.element);
    const int piece2 = map_.of(face2.element);
    if (map_.part(piece1) == map_.part(piece2)) {
      refuse(interfaceNamed(name), "both sides belong to part \"" + map_.part(piece1) +
                                       "\"; an interface joins two parts. Divide the part into two blocks there.");
    }
    builders.addFace(piece1, piece2, face1.nodes, pair.nodes2, integrate(face1, projection));
  }
  return builders.build(name);
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
      for (const NodalWeight& weight : integrate(face).weight) {
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
  const auto pairs = matchFaces(mesh_, side1, side2, projection);
  if (pairs.size() == side1.size() && pairs.size() == side2.size()) {
    return joinPairs(name, side1, side2, pairs, creaseAngle, projection);
  }
  if (!projection) {
    auto surfaces = joinDifferentFaces(name, side1, side2, creaseAngle);
    if (!surfaces.empty()) return surfaces;
    if (join) return join(sideSetNamed(sideSet1), side1, sideSetNamed(sideSet2), side2);
  }
  const auto nodes1 = nodesOf(side1);
  const auto nodes2 = nodesOf(side2);
  const Separation apart = separation(mesh_.nodes, nodes1, nodes2, projection);
  std::ostringstream message;
  message << "side sets \"" << sideSet1 << "\" (" << side1.size() << " faces, " << nodes1.size() << " nodes) and \""
          << sideSet2 << "\" (" << side2.size() << " faces, " << nodes2.size()
          << " nodes) do not conform: " << side1.size() - pairs.size() << " faces of the first and "
          << side2.size() - pairs.size()
          << " of the second have no partner with coinciding nodes and opposite normal on the other side. Seen "
          << (projection ? "along Projection Direction" : "in space") << ", a node of the first is between "
          << apart.smallest << " and " << apart.largest
          << " away from the nearest node of the second, farthest the one at " << text(mesh_.nodes[apart.node])
          << "; the shortest edge there is " << localSizes(mesh_, side1).at(apart.node)
          << " long. Mesh both sides with the same nodes and let both side "
          << "sets cover the same surface"
          << (projection ? ", or leave the direction out: then faces are joined that do not match."
                         : "; for sides that are open initially, give Projection Direction.");
  refuse(where, message.str());
}

std::vector<InterfaceSurface> InterfaceFinder::joinDifferentFaces(const std::string& name,
                                                                  const std::vector<Face>& side1,
                                                                  const std::vector<Face>& side2,
                                                                  double creaseAngle) const {
  const auto onePiece = [&](const std::vector<Face>& side) {
    return std::all_of(side.begin(), side.end(),
                       [&](const Face& face) { return map_.of(face.element) == map_.of(side[0].element); });
  };
  const int piece1 = map_.of(side1[0].element);
  const int piece2 = map_.of(side2[0].element);
  if (!onePiece(side1) || !onePiece(side2) || map_.part(piece1) == map_.part(piece2)) return {};
  const auto pairs = matchNodes(mesh_, side1, side2);
  if (pairs.size() != nodesOf(side1).size() || pairs.size() != nodesOf(side2).size()) return {};
  const std::map<int, int> partner(pairs.begin(), pairs.end());
  std::map<int, int> inverse;
  for (const auto& [node1, node2] : pairs) inverse[node2] = node1;
  SurfaceBuilders builders(mesh_, pieces_, creaseAngle);
  using Sums = std::map<int, base::Vector3>;  // of normals, by node of side 1
  const auto halved = [&](const Face& face, const std::vector<int>& nodes1, double orientation, Sums& sums) {
    FaceIntegrals half = integrate(face);
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

std::vector<InterfaceSurface> InterfaceFinder::joinNodes(const std::string& name, const std::vector<int>& pieces1,
                                                         const std::vector<int>& pieces2,
                                                         const std::vector<std::pair<int, int>>& pairs) const {
  std::vector<int> nodes1, nodes2;
  for (const auto& [node1, node2] : pairs) {
    nodes1.push_back(node1);
    nodes2.push_back(node2);
  }
  std::sort(nodes1.begin(), nodes1.end());
  std::sort(nodes2.begin(), nodes2.end());
  const NodalWeights weights1(mesh_, elements_, map_, pieces1, nodes1, depth_);
  const NodalWeights weights2(mesh_, elements_, map_, pieces2, nodes2, depth_);
  SurfaceBuilders builders(mesh_, pieces_, oneNormal);
  for (const auto& [node1, node2] : pairs) {
    // Where a body is cut, its pieces are tied to each other: one of them is enough.
    const auto holder = [&](const std::vector<int>& pieces, int node) {
      return *std::find_if(pieces.begin(), pieces.end(), [&](int piece) { return map_.has(piece, node); });
    };
    NodalWeight mean = weights1.total(node1).scaled(0.5);
    mean += weights2.total(node2).scaled(0.5, -1.0);
    builders.addNode(holder(pieces1, node1), holder(pieces2, node2), node1, node2, mean);
  }
  return builders.build(name);
}

std::vector<InterfaceSurface> InterfaceFinder::betweenParts(const std::string& name, const std::string& part1,
                                                            const std::string& part2, double creaseAngle,
                                                            const Joiner& join) const {
  const std::string where = interfaceNamed(name);
  const auto pieces1 = map_.named(where, part1);
  const auto pieces2 = map_.named(where, part2);
  if (part1 == part2) refuse(where, "Part 1 and Part 2 are both \"" + part1 + "\"; an interface joins two parts.");
  const auto skin1 = skin(elements_, map_.elements(pieces1));
  const auto skin2 = skin(elements_, map_.elements(pieces2));
  const auto faces = matchFaces(mesh_, skin1, skin2);
  const FaceOverlap overlap = findOverlap(mesh_, skin1, skin2, faces);
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
  if (faces.empty() && overlap.faces1.empty()) demandNoOverlap(mesh_, where, part1, skin1, part2, skin2);
  auto surfaces = joinPairs(name, skin1, skin2, faces, creaseAngle, std::nullopt);

  std::set<int> inFaces;
  for (const FacePair& pair : faces) {
    const auto& nodes = skin1[pair.face1].nodes;
    inFaces.insert(nodes.begin(), nodes.end());
  }
  std::set<std::pair<int, int>> single;
  const auto nodesIn = [&](const std::vector<int>& pieces) {
    std::set<int> nodes;
    for (const int piece : pieces) {
      const auto& more = pieces_[piece].nodes;
      nodes.insert(more.begin(), more.end());
    }
    return nodes;
  };
  const std::set<int> nodes2 = nodesIn(pieces2);
  for (const int node : nodesIn(pieces1)) {
    if (nodes2.count(node) > 0 && inFaces.count(node) == 0) single.emplace(node, node);
  }
  if (faces.empty()) {
    for (const auto& pair : matchNodes(mesh_, skin1, skin2)) single.insert(pair);
  }
  if (!overlap.faces1.empty()) {
    const auto facesOf = [](std::size_t count, const std::string& part) {
      return std::to_string(count) + (count == 1 ? " face of part \"" : " faces of part \"") + part + "\"";
    };
    refuse(where, facesOf(overlap.faces1.size(), part1) + " and " + facesOf(overlap.faces2.size(), part2) +
                      " lie on each other, but their nodes do not coincide, the first of them at " +
                      text(mesh_.nodes[skin1[overlap.faces1[0]].nodes[0]]) + "; of the others " +
                      std::to_string(faces.size()) +
                      " of each part match. Mesh both parts with the same nodes where they touch.");
  }
  for (const auto& pair : overlap.nodes) {
    if (inFaces.count(pair.first) == 0) single.insert(pair);
  }
  const auto more = joinNodes(name, pieces1, pieces2, {single.begin(), single.end()});
  surfaces.insert(surfaces.end(), more.begin(), more.end());
  if (surfaces.empty()) {
    std::ostringstream message;
    message
        << "parts \"" << part1 << "\" and \"" << part2
        << "\" have no coincident faces and no shared or coincident nodes; their nearest nodes are "
        << separation(mesh_.nodes, nodesOf(skin1), nodesOf(skin2)).smallest
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
  const auto skinOf = [&](const std::string& part) { return skin(elements_, map_.elements(map_.named(where, part))); };
  return join(partNamed(part1), skinOf(part1), partNamed(part2), skinOf(part2));
}

std::vector<InterfaceSurface> InterfaceFinder::cuts() const {
  std::map<std::string, std::vector<int>> parts;
  for (int piece = 0; piece < map_.count(); ++piece) parts[map_.part(piece)].push_back(piece);
  std::vector<InterfaceSurface> surfaces;
  for (const auto& [part, pieces] : parts) {
    if (pieces.size() < 2) continue;
    const auto more = cut(part + " cut", pieces);
    surfaces.insert(surfaces.end(), more.begin(), more.end());
  }
  return surfaces;
}

std::vector<InterfaceSurface> InterfaceFinder::cut(const std::string& name, const std::vector<int>& pieces) const {
  SurfaceBuilders builders(mesh_, pieces_, oneNormal);
  std::map<std::vector<int>, Face> open;           // by sorted nodes: faces whose other side has not come yet
  std::map<int, std::vector<std::set<int>>> tied;  // per node: groups of pieces that faces join there
  for (const int piece : pieces) {
    for (const int node : pieces_[piece].nodes) tied[node].push_back({piece});
  }
  for (const int piece : pieces) {
    for (Face& face : skin(elements_, pieces_[piece].elements)) {
      std::vector<int> key = face.nodes;
      std::sort(key.begin(), key.end());
      const auto other = open.find(key);
      if (other == open.end()) {
        open.emplace(std::move(key), std::move(face));
        continue;
      }
      const Face& first = other->second;
      const int firstPiece = map_.of(first.element);
      builders.addFace(firstPiece, piece, first.nodes, first.nodes, integrate(first));
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
    const auto more = joinNodes(name, {ends.first}, {ends.second}, nodes);
    surfaces.insert(surfaces.end(), more.begin(), more.end());
  }
  return surfaces;
}

std::vector<InterfaceSurface> InterfaceFinder::onFaces(const std::string& name, const std::vector<Face>& faces,
                                                       double creaseAngle) const {
  SurfaceBuilders builders(mesh_, pieces_, creaseAngle);
  for (const Face& face : faces) builders.addFace(map_.of(face.element), -1, face.nodes, {}, integrate(face));
  return builders.build(name);
}

std::vector<InterfaceSurface> InterfaceFinder::onSideSet(const std::string& name, const std::string& sideSet,
                                                         double creaseAngle) const {
  return onFaces(name, facesOf(boundaryNamed(name), sideSet), creaseAngle);
}

std::vector<InterfaceSurface> InterfaceFinder::onNodeSet(const std::string& name, const std::string& nodeSet,
                                                         const std::string& part, double creaseAngle) const {
  const std::string where = boundaryNamed(name);
  const NodeSet& set = findSet(where, mesh_.nodeSets, nodeSet, "node set");
  if (set.node.empty()) refuse(where, "node set \"" + nodeSet + "\" is empty.");
  std::vector<int> pieces(map_.count());
  std::iota(pieces.begin(), pieces.end(), 0);
  if (!part.empty()) pieces = map_.named(where, part);
  std::set<int> nodes;
  for (const int node : set.node) {
    if (std::any_of(pieces.begin(), pieces.end(), [&](int piece) { return map_.has(piece, node); })) {
      nodes.insert(node);
    } else if (part.empty()) {
      refuse(where, "node set \"" + nodeSet + "\" has a node at " + text(mesh_.nodes[node]) +
                        " that belongs to no part. Add a part with its block, or choose another node set.");
    }
  }
  if (nodes.empty()) refuse(where, "node set \"" + nodeSet + "\" has no node of part \"" + part + "\".");

  std::vector<Face> faces;
  for (Face& face : skin(elements_, map_.elements(pieces))) {
    if (std::all_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return nodes.count(node) > 0; })) {
      faces.push_back(std::move(face));
    }
  }
  if (nodesOf(faces).size() == nodes.size()) return onFaces(name, faces, creaseAngle);

  const NodalWeights weights(mesh_, elements_, map_, pieces, {nodes.begin(), nodes.end()}, depth_);
  SurfaceBuilders builders(mesh_, pieces_, oneNormal);
  for (const int node : nodes) {
    for (const auto& [piece, weight] : weights.at(node)) {
      builders.addNode(piece, -1, node, -1, weight);
    }
  }
  return builders.build(name);
}

void InterfaceFinder::demandSurface(const std::string& where, const std::string& sideSet) const {
  const auto faces = facesOf(where, sideSet);
  const auto inner = innerFaces(mesh_, elements_, map_, faces);
  if (inner.empty()) return;
  refuse(where, std::to_string(inner.size()) + " of the " + std::to_string(faces.size()) + " faces of side set \"" +
                    sideSet + "\" lie inside of part \"" + map_.part(map_.of(inner[0].element)) +
                    "\", the first of them at " + text(mesh_.nodes[inner[0].nodes[0]]) +
                    ". A law acts on the surface of a part: divide the part there into two blocks, or choose another "
                    "side set.");
}

}  // namespace harmos::mesh
