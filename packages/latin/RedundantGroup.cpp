#include <harmos/latin/detail/RedundantGroup.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <harmos/assembly/NodeClusters.hpp>

namespace harmos::latin {
namespace {

using assembly::NodeClusters;
using Node = NodeClusters::Node;

bool hasUnknowns(const assembly::Interface& interface, int index, const EliminatedBoundaries& eliminated) {
  return !interface.law->prescribesTraction() && !eliminated.contains(index) && interface.mass.empty();
}

const EliminatedBoundaries::Node* heldNode(const EliminatedBoundaries& eliminated, const Node& node) {
  const auto& nodes = eliminated.nodes(node.first);
  const auto at = std::lower_bound(nodes.begin(), nodes.end(), node.second,
                                   [](const auto& one, int wanted) { return one.node < wanted; });
  return at != nodes.end() && at->node == node.second && at->isHeld ? &*at : nullptr;
}

using Holders = std::map<Node, std::vector<RedundantGroup::Holder>>;

Holders holdersOf(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated) {
  Holders holders;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    if (!eliminated.contains(static_cast<int>(i))) continue;
    const assembly::Interface& interface = assembly.interfaces[i];
    for (int p = 0; p < interface.pairs(); ++p)
      holders[{interface.body1, interface.trace1.node(p)}].push_back({static_cast<int>(i), p, 1.0});
  }
  return holders;
}

}  // namespace

std::vector<RedundantGroup> findRedundantGroups(const assembly::Assembly& assembly,
                                                const EliminatedBoundaries& eliminated) {
  const NodeClusters clusters(
      assembly.interfaces, [&](int index) { return hasUnknowns(assembly.interfaces[index], index, eliminated); },
      [&](const Node& node) { return heldNode(eliminated, node) != nullptr; });
  const Holders holders = holdersOf(assembly, eliminated);
  std::vector<RedundantGroup> groups;
  for (const NodeClusters::Cluster& cluster : clusters.all()) {
    if (!cluster.mayHideTractions()) continue;
    RedundantGroup group;
    for (const auto& [interface, pair] : cluster.pairs)
      group.pairs.push_back({interface, pair, assembly.interfaces[interface].area[pair], {}});
    std::map<Node, int> rows;
    const int columns = 3 * static_cast<int>(group.pairs.size());
    group.equilibrium.shape(3 * cluster.nodes, columns);
    for (std::size_t i = 0; i < group.pairs.size(); ++i) {
      RedundantGroup::Pair& pair = group.pairs[i];
      const assembly::Interface& interface = assembly.interfaces[pair.interface];
      for (int side = 0; side < interface.sides(); ++side) {
        for (const auto& entry : interface.trace(side).row(pair.pair)) {
          const Node node{interface.body(side), entry.node};
          const int row = 3 * rows.emplace(node, static_cast<int>(rows.size())).first->second;
          const double share = (side == 0 ? 1.0 : -1.0) * entry.weight, force = share * std::sqrt(pair.area);
          const EliminatedBoundaries::Node* held = heldNode(eliminated, node);
          const auto holding = holders.find(node);
          for (std::size_t j = 0; held != nullptr && j < holding->second.size(); ++j) {
            pair.holders.push_back(holding->second[j]);
            pair.holders.back().share = share;
          }
          for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
              const double free = held != nullptr ? held->free[a][b] : (a == b ? 1.0 : 0.0);
              group.equilibrium(row + a, 3 * static_cast<int>(i) + b) += force * free;
            }
          }
        }
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace harmos::latin
