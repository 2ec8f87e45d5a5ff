#include <harmos/mesh/Piece.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {

namespace {

/// Two of `elements` that have the same nodes, by their numbers; the second is -1 when there are none.
std::pair<int, int> copies(const Elements& all, const std::vector<int>& elements) {
  std::vector<std::pair<std::vector<int>, int>> nodes;
  for (const int element : elements) {
    nodes.emplace_back(std::vector<int>(all.nodes(element), all.nodes(element) + nodesPerElement(all.type(element))),
                       element);
    std::sort(nodes.back().first.begin(), nodes.back().first.end());
  }
  std::sort(nodes.begin(), nodes.end());
  const auto found =
      std::adjacent_find(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
  return found == nodes.end() ? std::pair(-1, -1) : std::pair(found->second, std::next(found)->second);
}

}  // namespace

Piece makePiece(const Mesh& mesh, const std::string& name, const std::vector<std::string>& blocks) {
  const auto refuse = [&](const std::string& what) {
    throw base::Error("Part \"" + name + "\": " + what, base::ExitCode::input);
  };
  const Elements all(mesh);
  std::vector<int> elements;
  for (const std::string& wanted : blocks) {
    const auto found = std::find_if(mesh.blocks.begin(), mesh.blocks.end(),
                                    [&](const ElementBlock& block) { return block.name == wanted; });
    if (found == mesh.blocks.end()) {
      std::vector<std::string> known;
      for (const ElementBlock& block : mesh.blocks) known.push_back(block.name);
      refuse("the mesh has no block \"" + wanted + "\". " + base::suggestName(wanted, known, "Blocks"));
    }
    const int block = static_cast<int>(found - mesh.blocks.begin());
    for (int i = 0; i < found->elements(); ++i) elements.push_back(all.first(block) + i);
  }
  std::sort(elements.begin(), elements.end());
  if (std::adjacent_find(elements.begin(), elements.end()) != elements.end()) refuse("names a block twice.");
  if (elements.empty()) refuse("has no elements; name a block that has some.");
  const auto [first, second] = copies(all, elements);
  if (second >= 0) {
    refuse(elementName(mesh, first) + " and " + elementName(mesh, second) +
           " have the same nodes; remove one of them.");
  }
  return makePiece(mesh, name, name, std::move(elements));
}

Piece makePiece(const Mesh& mesh, const std::string& name, const std::string& part, std::vector<int> elements) {
  const Elements all(mesh);
  Piece piece{name, std::move(elements), {}, part, 0};
  for (const int element : piece.elements) {
    const int* nodes = all.nodes(element);
    piece.nodes.insert(piece.nodes.end(), nodes, nodes + nodesPerElement(all.type(element)));
  }
  std::sort(piece.nodes.begin(), piece.nodes.end());
  piece.nodes.erase(std::unique(piece.nodes.begin(), piece.nodes.end()), piece.nodes.end());
  return piece;
}

int localNode(const Piece& piece, int node) {
  const auto found = std::lower_bound(piece.nodes.begin(), piece.nodes.end(), node);
  return found == piece.nodes.end() || *found != node ? -1 : static_cast<int>(found - piece.nodes.begin());
}

}  // namespace harmos::mesh
