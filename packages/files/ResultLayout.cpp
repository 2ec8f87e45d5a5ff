#include <harmos/files/ResultLayout.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Skin.hpp>

namespace harmos::files {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<int> sorted(std::vector<int> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Hands out every name once.
class Names {
 public:
  std::string take(std::string name) {
    while (!used_.insert(name).second) name += "_set";
    return name;
  }

 private:
  std::set<std::string> used_;
};

void addBlocks(const mesh::Mesh& mesh, const mesh::Elements& elements, const mesh::Piece& piece, int firstNode,
               Names& names, PartsLayout& layout) {
  std::map<mesh::ElementType, std::vector<std::size_t>> byType;  // positions in part.elements
  for (std::size_t i = 0; i < piece.elements.size(); ++i) byType[elements.type(piece.elements[i])].push_back(i);
  std::vector<int> local(mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < piece.nodes.size(); ++i) local[at(piece.nodes[i])] = firstNode + static_cast<int>(i);

  int next = layout.mesh.elements();
  std::vector<int> position(piece.elements.size());
  for (const auto& [type, members] : byType) {
    const std::string typeName = mesh::exodusName(type);
    ResultMesh::Block block;
    block.name = names.take(byType.size() == 1 ? piece.name : piece.name + "_" + lowerCase(typeName));
    block.type = typeName;
    block.nodesPerElement = mesh::nodesPerElement(type);
    for (std::size_t i : members) {
      const int* nodes = elements.nodes(piece.elements[i]);
      for (int k = 0; k < block.nodesPerElement; ++k) block.connectivity.push_back(local[at(nodes[k])]);
      position[i] = next++;
    }
    layout.mesh.blocks.push_back(std::move(block));
  }
  layout.element.push_back(std::move(position));
}

/// Numbers of the user's file, which must be of one element or node each.
void number(const mesh::Numbering& numbering, const std::vector<mesh::Piece>& pieces, PartsLayout& layout) {
  std::vector<std::int64_t> elements(static_cast<std::size_t>(layout.mesh.elements())), nodes;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (std::size_t i = 0; i < pieces[p].elements.size(); ++i)
      elements[at(layout.element[p][i])] = numbering.ofElement(pieces[p].elements[i]);
    for (const int node : pieces[p].nodes) nodes.push_back(numbering.ofNode(node).value_or(0));
  }
  if (!numbering.isSplit) layout.mesh.elementNumbers = mesh::unlessPositions(std::move(elements));
  if (mesh::areDistinct(nodes)) layout.mesh.nodeNumbers = mesh::unlessPositions(std::move(nodes));
}

/// Outer sides of a part by their mesh nodes.
std::map<std::vector<int>, mesh::Face> skinByNodes(const mesh::Elements& elements, const mesh::Piece& piece) {
  std::map<std::vector<int>, mesh::Face> result;
  for (auto& face : mesh::skin(elements, piece.elements)) {
    auto key = sorted(face.nodes);
    result.emplace(std::move(key), std::move(face));
  }
  return result;
}

/// Exodus names of faces by the number of their nodes.
std::map<std::size_t, const char*> typesOfFaces(int dimension) {
  if (dimension == 2) return {{1, "SPHERE"}, {2, "BAR2"}, {3, "BAR3"}};
  return {{1, "SPHERE"}, {3, "TRI3"}, {4, "SHELL4"}, {6, "TRI6"}, {8, "SHELL8"}, {9, "SHELL9"}};
}

}  // namespace

PartsLayout layOutParts(const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces,
                        const std::vector<mesh::InterfaceSurface>& surfaces) {
  const mesh::Elements elements(mesh);
  PartsLayout layout;
  layout.mesh.dimension = mesh.dimension;
  Names names;
  std::vector<std::map<std::vector<int>, mesh::Face>> skins;
  for (const auto& piece : pieces) {
    const int first = static_cast<int>(layout.mesh.nodes.size());
    layout.firstNode.push_back(first);
    for (int node : piece.nodes) layout.mesh.nodes.push_back(mesh.nodes[at(node)]);
    addBlocks(mesh, elements, piece, first, names, layout);
    skins.push_back(skinByNodes(elements, piece));
  }
  number(mesh.numbering, pieces, layout);

  // Pieces of one interface between cut parts share its name and go into one set.
  std::map<std::string, mesh::SideSet> sideSets;
  std::map<std::string, mesh::NodeSet> nodeSets;
  std::vector<std::string> order;
  for (const auto& surface : surfaces) {
    for (const int side : {0, 1}) {
      const int p = side == 0 ? surface.piece1 : surface.piece2;
      if (p < 0) continue;
      const auto& piece = pieces[at(p)];
      const auto& trace = side == 0 ? surface.trace1 : surface.trace2;
      const std::string name = surface.piece2 < 0 ? surface.name : surface.name + (side == 0 ? "_1" : "_2");
      if (std::find(order.begin(), order.end(), name) == order.end()) order.push_back(name);
      if (surface.face.empty() || !trace.isSelection()) {
        std::set<int> known;
        for (int pair = 0; pair < trace.points(); ++pair) {
          for (const auto& entry : trace.row(pair)) {
            if (known.insert(entry.node).second) nodeSets[name].node.push_back(layout.firstNode[at(p)] + entry.node);
          }
        }
        continue;
      }
      for (const auto& face : surface.face) {
        std::vector<int> key;
        for (int pair : face) key.push_back(piece.nodes[at(trace.node(pair))]);
        const auto found = skins[at(p)].find(sorted(std::move(key)));
        if (found == skins[at(p)].end()) continue;  // a face of the other side that this mesh does not have
        const auto position = std::lower_bound(piece.elements.begin(), piece.elements.end(), found->second.element) -
                              piece.elements.begin();
        sideSets[name].element.push_back(layout.element[at(p)][position]);
        sideSets[name].side.push_back(found->second.side);
      }
    }
  }
  for (const auto& name : order) {
    if (const auto set = sideSets.find(name); set != sideSets.end()) {
      layout.mesh.sideSets.push_back(set->second);
      layout.mesh.sideSets.back().name = names.take(name);
    }
    if (const auto set = nodeSets.find(name); set != nodeSets.end()) {
      layout.mesh.nodeSets.push_back(set->second);
      layout.mesh.nodeSets.back().name = names.take(name);
    }
  }
  return layout;
}

InterfacesLayout layOutInterfaces(int dimension, const std::vector<mesh::InterfaceSurface>& surfaces) {
  InterfacesLayout layout;
  layout.mesh.dimension = dimension;
  const std::map<std::size_t, const char*> types = typesOfFaces(dimension);
  std::vector<std::pair<std::string, std::size_t>> order;  // interface and nodes per face
  std::map<std::pair<std::string, std::size_t>, std::vector<int>> faces;
  for (const auto& surface : surfaces) {
    const int first = static_cast<int>(layout.mesh.nodes.size());
    layout.firstPair.push_back(first);
    layout.mesh.nodes.insert(layout.mesh.nodes.end(), surface.position.begin(), surface.position.end());
    const auto add = [&](const std::vector<int>& face) {
      const std::pair<std::string, std::size_t> key{surface.name, face.size()};
      if (faces.find(key) == faces.end()) order.push_back(key);
      for (int pair : face) faces[key].push_back(first + pair);
    };
    for (const auto& face : surface.face) add(face);
    if (surface.face.empty())
      for (int pair = 0; pair < surface.pairs(); ++pair) add({pair});
  }
  Names names;
  for (const auto& key : order) {
    const std::string type = types.at(key.second);
    const auto sameName =
        std::count_if(order.begin(), order.end(), [&](const auto& o) { return o.first == key.first; });
    layout.mesh.blocks.push_back({names.take(sameName == 1 ? key.first : key.first + "_" + lowerCase(type)), type,
                                  static_cast<int>(key.second), std::move(faces[key])});
  }
  return layout;
}

}  // namespace harmos::files
