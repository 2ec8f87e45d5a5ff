#include <harmos/mesh/Refinement.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/mesh/Elements.hpp>
#include <harmos/mesh/Skin.hpp>
#include <harmos/mesh/detail/Subdivision.hpp>

namespace harmos::mesh {
namespace {

/// A place between corners: their numbers, ascending, with weights in units of `unit`; the same from every element.
using Place = std::vector<std::pair<int, int>>;
// Quadratic children of a split element have nodes at quarters of each of three directions.
constexpr double unit = 64.0;
// Relative difference of lengths that rounding does not make.
constexpr double shorter = 1e-9;

[[noreturn]] void refuse(const ElementBlock& block, const std::string& what) {
  throw base::Error("block \"" + block.name + "\" " + what, base::ExitCode::input);
}

/// Makes each node once.
class Nodes {
 public:
  explicit Nodes(std::vector<base::Vector3> nodes) : nodes_(std::move(nodes)), old_(nodes_.size()) {}

  /// The node of this number stands at a place.
  void set(Place place, int node) { numbers_.emplace(std::move(place), node); }
  int at(const Place& place, const std::function<base::Vector3()>& where) {
    const auto [found, isNew] = numbers_.emplace(place, static_cast<int>(nodes_.size()));
    if (isNew) nodes_.push_back(where());
    return found->second;
  }
  const std::map<Place, int>& all() const { return numbers_; }
  bool isOld(int node) const { return static_cast<std::size_t>(node) < old_; }
  std::vector<base::Vector3> take() { return std::move(nodes_); }

 private:
  std::vector<base::Vector3> nodes_;
  std::size_t old_;
  std::map<Place, int> numbers_;
};

Place placeOf(const ShapeFunctions& corners, int point, const int* nodes) {
  Place place;
  for (int a = 0; a < corners.nodes; ++a) {
    const int weight = static_cast<int>(std::lround(unit * corners.value[point * corners.nodes + a]));
    if (weight != 0) place.emplace_back(nodes[a], weight);
  }
  std::sort(place.begin(), place.end());
  return place;
}

/// Which of the ways to divide an element is taken: the one with the shortest diagonal.
std::size_t choose(const std::vector<Subdivision>& ways, const Mesh& mesh, const int* nodes) {
  if (ways.size() == 1) return 0;
  static constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static constexpr int ends[3][2] = {{0, 5}, {1, 3}, {2, 4}};
  const auto middle = [&](int edge) {
    return 0.5 * (mesh.nodes[nodes[edges[edge][0]]] + mesh.nodes[nodes[edges[edge][1]]]);
  };
  std::size_t best = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t way = 0; way < ways.size(); ++way) {
    const double length = distance(middle(ends[way][0]), middle(ends[way][1]));
    if (length < (1.0 - shorter) * shortest) {  // of equal ones the first, on all machines
      shortest = length;
      best = way;
    }
  }
  return best;
}

class Divider {
 public:
  /// All ways to divide the elements of a block.
  using Ways = std::function<std::vector<Subdivision>(const ElementBlock&)>;

  Divider(const Mesh& mesh, const Ways& ways) : old_(mesh), elements_(mesh), nodes_(mesh.nodes) {
    for (const ElementBlock& block : mesh.blocks) {
      ways_.push_back(ways(block));
      const double perElement = static_cast<double>(ways_.back().front().places.size());
      expected_ += perElement * block.elements();
    }
    if (expected_ > std::numeric_limits<int>::max()) {
      throw base::Error("the mesh would have more nodes than can be counted.", base::ExitCode::input);
    }
  }

  Mesh divide() {
    keepNodes();
    Mesh mesh;
    mesh.dimension = old_.dimension;
    mesh.unreadBlocks = old_.unreadBlocks;
    int first = 0;
    for (std::size_t b = 0; b < old_.blocks.size(); ++b) {
      firstChild_.push_back(first);
      mesh.blocks.push_back(divide(old_.blocks[b], ways_[b]));
      first += mesh.blocks.back().elements();
    }
    for (const SideSet& set : old_.sideSets) mesh.sideSets.push_back(divide(set));
    for (const NodeSet& set : old_.nodeSets) mesh.nodeSets.push_back(divide(set));
    mesh.nodes = nodes_.take();
    mesh.numbering = numbering(mesh.nodes.size());
    return mesh;
  }

 private:
  /// Children have the number of their parent, new nodes none.
  Numbering numbering(std::size_t nodes) const {
    Numbering result = old_.numbering;
    int element = 0;
    std::vector<std::int64_t> numbers;
    for (std::size_t b = 0; b < ways_.size(); ++b) {
      const std::size_t children = ways_[b].front().children.size();
      result.isSplit = result.isSplit || children > 1;
      for (int e = 0; e < old_.blocks[b].elements(); ++e)
        numbers.insert(numbers.end(), children, old_.numbering.ofElement(element++));
    }
    result.element = unlessPositions(std::move(numbers));
    if (result.node.empty() && nodes > old_.nodes.size()) {
      result.node.resize(old_.nodes.size());
      std::iota(result.node.begin(), result.node.end(), 1);
    }
    return result;
  }

  /// The nodes that elements have already, by their places.
  void keepNodes() {
    for (const ElementBlock& block : old_.blocks) {
      const ShapeFunctions corners = shapeFunctions(linearType(block.type), nodePlaces(block.type));
      for (int e = 0; e < block.elements(); ++e) {
        const int* nodes = block.connectivity.data() + std::ptrdiff_t{e} * corners.points;
        for (int a = 0; a < corners.points; ++a) nodes_.set(placeOf(corners, a, nodes), nodes[a]);
      }
    }
  }

  ElementBlock divide(const ElementBlock& block, const std::vector<Subdivision>& ways) {
    ElementBlock result{block.name, block.id, ways.front().type, {}};
    const int perElement = nodesPerElement(block.type);
    for (int e = 0; e < block.elements(); ++e) {
      const int* nodes = block.connectivity.data() + std::ptrdiff_t{e} * perElement;
      wayOf_.push_back(choose(ways, old_, nodes));
      const Subdivision& way = ways[wayOf_.back()];
      std::vector<int> numbers;
      for (int p = 0; p < way.geometry.points; ++p) {
        numbers.push_back(nodes_.at(placeOf(way.corners, p, nodes), [&] {
          base::Vector3 place{};
          for (int a = 0; a < perElement; ++a) {
            place = place + way.geometry.value[p * perElement + a] * old_.nodes[nodes[a]];
          }
          return place;
        }));
      }
      for (const std::vector<int>& child : way.children) {
        for (const int node : child) result.connectivity.push_back(numbers[node]);
      }
    }
    return result;
  }

  SideSet divide(const SideSet& set) const {
    SideSet result{set.name, set.id, {}, {}};
    for (std::size_t i = 0; i < set.element.size(); ++i) {
      const int element = set.element[i], block = elements_.block(element);
      const Subdivision& way = ways_[block][wayOf_[element]];
      const int first = firstChild_[block] + elements_.indexInBlock(element) * static_cast<int>(way.children.size());
      for (const auto& [child, side] : way.sides[set.side[i]]) {
        result.element.push_back(first + child);
        result.side.push_back(side);
      }
    }
    return result;
  }

  NodeSet divide(const NodeSet& set) {
    const std::vector<std::set<int>>& around = surroundings();
    const std::set<int> old(set.node.begin(), set.node.end());
    NodeSet result = set;
    for (const auto& [place, node] : nodes_.all()) {
      if (nodes_.isOld(node)) continue;
      if (!std::all_of(place.begin(), place.end(), [&](const auto& corner) { return old.count(corner.first) > 0; })) {
        continue;
      }
      const auto isOn = [&, &corners = place](int group) {
        return std::all_of(corners.begin(), corners.end(),
                           [&](const auto& corner) { return around[corner.first].count(group) > 0; });
      };
      const std::set<int>& groups = around[place.front().first];
      if (std::any_of(groups.begin(), groups.end(),
                      [&](int group) { return isOn(group) && (group >= elements_.count() || isWhole(group, old)); })) {
        result.node.push_back(node);
      }
    }
    return result;
  }

  bool isWhole(int element, const std::set<int>& set) const {
    const int* nodes = elements_.nodes(element);
    return std::all_of(nodes, nodes + cornersPerElement(elements_.type(element)),
                       [&](int node) { return set.count(node) > 0; });
  }

  /// Per old node, the elements that it is a corner of and, counted on from them, sides of the skins of the blocks.
  const std::vector<std::set<int>>& surroundings() {
    if (!around_.empty()) return around_;
    around_.resize(old_.nodes.size());
    int group = elements_.count();
    for (std::size_t b = 0; b < old_.blocks.size(); ++b) {
      std::vector<int> list(old_.blocks[b].elements());
      std::iota(list.begin(), list.end(), elements_.first(static_cast<int>(b)));
      for (const int element : list) {
        const int* nodes = elements_.nodes(element);
        for (int a = 0; a < cornersPerElement(elements_.type(element)); ++a) around_[nodes[a]].insert(element);
      }
      for (const Face& face : skin(elements_, list)) {
        const int corners = cornersOfFace(old_.dimension, face.nodes.size());
        for (int a = 0; a < corners; ++a) around_[face.nodes[a]].insert(group);
        ++group;
      }
    }
    return around_;
  }

  const Mesh& old_;
  Elements elements_;
  Nodes nodes_;
  std::vector<std::vector<Subdivision>> ways_;  // per block
  std::vector<std::size_t> wayOf_;              // per element
  std::vector<int> firstChild_;                 // per block
  std::vector<std::set<int>> around_;
  double expected_ = 0.0;
};

}  // namespace

ElementType raised(ElementType type) {
  switch (type) {
    case ElementType::tri3:
      return ElementType::tri6;
    case ElementType::quad4:
      return ElementType::quad8;
    case ElementType::tet4:
      return ElementType::tet10;
    case ElementType::wedge6:
      return ElementType::wedge15;
    case ElementType::hex8:
      return ElementType::hex20;
    default:
      return type;
  }
}

Mesh refined(const Mesh& mesh) {
  return Divider(mesh,
                 [](const ElementBlock& block) {
                   std::vector<Subdivision> ways;
                   for (const auto& children : splits(block.type)) ways.emplace_back(block.type, block.type, children);
                   if (ways.empty())
                     refuse(block, "has pyramids, which do not split into pyramids; mesh it finer instead.");
                   return ways;
                 })
      .divide();
}

Mesh raised(const Mesh& mesh) {
  return Divider(mesh,
                 [](const ElementBlock& block) {
                   if (block.type == ElementType::pyramid5) {
                     refuse(block, "has pyramids, of which there are only linear ones; mesh it with other elements.");
                   }
                   return std::vector<Subdivision>{
                       Subdivision(block.type, raised(block.type), {nodePlaces(linearType(block.type))})};
                 })
      .divide();
}

}  // namespace harmos::mesh
