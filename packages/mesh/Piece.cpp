#include <harmos/mesh/Piece.hpp>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::mesh {

namespace {

/// Two of `elements` that have the same nodes, by their numbers; the second is -1 when there are none.
std::pair<int, int> copies(const Elements& all, const std::vector<int>& elements) {
  // The least node and the sum of all tell nearly all apart, without a list for each.
  struct Key {
    int least;
    long sum;
    int element;
    bool operator<(const Key& other) const {
      return std::tie(least, sum, element) < std::tie(other.least, other.sum, other.element);
    }
  };
  std::vector<Key> keys;
  keys.reserve(elements.size());
  for (const int element : elements) {
    const int* nodes = all.nodes(element);
    const int* end = nodes + nodesPerElement(all.type(element));
    keys.push_back({*std::min_element(nodes, end), std::accumulate(nodes, end, 0L), element});
  }
  std::sort(keys.begin(), keys.end());
  const auto sorted = [&all](int element) {
    const int* nodes = all.nodes(element);
    std::vector<int> list(nodes, nodes + nodesPerElement(all.type(element)));
    std::sort(list.begin(), list.end());
    return list;
  };
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t j = i + 1; j < keys.size() && keys[j].least == keys[i].least && keys[j].sum == keys[i].sum; ++j) {
      if (sorted(keys[i].element) == sorted(keys[j].element)) return {keys[i].element, keys[j].element};
    }
  }
  return {-1, -1};
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
