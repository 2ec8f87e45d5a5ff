#include <harmos/latin/detail/RedundantGroup.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <harmos/base/DisjointSets.hpp>

namespace harmos::latin {
namespace {

// What is done with a group takes dense algebra of its size.
constexpr std::size_t mostPairs = 60;

using Node = std::pair<int, int>;  // body, node

/// Nodes that pairs join.
struct Joined {
  std::map<Node, int> numbers;
  base::DisjointSets sets;
  /// Number of a node, new or not.
  int number(const Node& node) {
    const auto [at, isNew] = numbers.emplace(node, static_cast<int>(sets.size()));
    if (isNew) sets.add();
    return at->second;
  }
};

bool hasUnknowns(const assembly::Interface& interface, int index, const EliminatedBoundaries& eliminated) {
  return !interface.law->prescribesTraction() && !eliminated.contains(index) && interface.mass.empty();
}

const EliminatedBoundaries::Node* heldNode(const EliminatedBoundaries& eliminated, const Node& node) {
  const auto& nodes = eliminated.nodes(node.first);
  const auto at = std::lower_bound(nodes.begin(), nodes.end(), node.second,
                                   [](const auto& one, int wanted) { return one.node < wanted; });
  return at != nodes.end() && at->node == node.second && at->isHeld ? &*at : nullptr;
}

/// What is known of the nodes that hang together.
struct Cluster {
  int nodes = 0, links = 0, ends = 0;  // ends: on the ground, or at held nodes
  std::vector<RedundantGroup::Pair> pairs;
  bool mayHideTractions() const { return !pairs.empty() && (links >= nodes || ends > 1); }
};

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

std::vector<RedundantGroup> findHeldGroups(const assembly::Assembly& assembly, const EliminatedBoundaries& eliminated) {
  std::vector<RedundantGroup> groups;
  for (const auto& [node, holders] : holdersOf(assembly, eliminated)) {
    if (holders.size() < 2) continue;
    RedundantGroup group;
    group.equilibrium.shape(3, 3 * static_cast<int>(holders.size()));
    for (std::size_t i = 0; i < holders.size(); ++i) {
      const double area = assembly.interfaces[holders[i].interface].area[holders[i].pair];
      group.pairs.push_back({holders[i].interface, holders[i].pair, area, {}});
      for (int c = 0; c < 3; ++c) group.equilibrium(c, 3 * static_cast<int>(i) + c) = std::sqrt(area);
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<RedundantGroup> findRedundantGroups(const assembly::Assembly& assembly,
                                                const EliminatedBoundaries& eliminated) {
  Joined joined;
  const auto visit = [&](const auto& action) {
    for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
      const assembly::Interface& interface = assembly.interfaces[i];
      if (!hasUnknowns(interface, static_cast<int>(i), eliminated)) continue;
      for (int p = 0; p < interface.pairs(); ++p) action(static_cast<int>(i), interface, p);
    }
  };
  const auto firstOf = [&](const assembly::Interface& interface, int p) {
    return joined.number({interface.body1, interface.trace1.row(p).begin()->node});
  };
  visit([&](int, const assembly::Interface& interface, int p) {
    const int first = firstOf(interface, p);
    for (int side = 0; side < interface.sides(); ++side) {
      for (const auto& entry : interface.trace(side).row(p))
        joined.sets.join(first, joined.number({interface.body(side), entry.node}));
    }
  });

  std::vector<Cluster> clusters(joined.sets.size());
  for (const auto& [node, number] : joined.numbers) {
    Cluster& cluster = clusters[joined.sets.root(number)];
    ++cluster.nodes;
    if (heldNode(eliminated, node) != nullptr) ++cluster.ends;
  }
  visit([&](int index, const assembly::Interface& interface, int p) {
    Cluster& cluster = clusters[joined.sets.root(firstOf(interface, p))];
    ++(interface.sides() == 2 ? cluster.links : cluster.ends);
    cluster.pairs.push_back({index, p, interface.area[p], {}});
  });

  const Holders holders = holdersOf(assembly, eliminated);
  std::vector<RedundantGroup> groups;
  for (Cluster& cluster : clusters) {
    if (!cluster.mayHideTractions() || cluster.pairs.size() > mostPairs) continue;
    RedundantGroup group;
    group.pairs = std::move(cluster.pairs);
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
