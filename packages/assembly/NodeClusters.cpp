#include <harmos/assembly/NodeClusters.hpp>

#include <map>

#include <harmos/base/DisjointSets.hpp>

namespace harmos::assembly {
namespace {

/// Numbers of nodes, with those that hang together.
struct Joined {
  std::map<NodeClusters::Node, int> numbers;
  base::DisjointSets sets;

  /// Of a node, new or not.
  int number(const NodeClusters::Node& node) {
    const auto [at, isNew] = numbers.try_emplace(node);
    if (isNew) at->second = sets.add();
    return at->second;
  }
  int firstOf(const Interface& interface, int pair) {
    return number({interface.body1, interface.trace1.row(pair).begin()->node});
  }
};

}  // namespace

NodeClusters::NodeClusters(const std::vector<Interface>& interfaces, const std::function<bool(int)>& takes,
                           const std::function<bool(const Node&)>& isHeld) {
  const auto visit = [&](const auto& action) {
    for (std::size_t i = 0; i < interfaces.size(); ++i) {
      if (!takes(static_cast<int>(i))) continue;
      for (int p = 0; p < interfaces[i].pairs(); ++p) action(interfaces[i], Pair{static_cast<int>(i), p});
    }
  };
  Joined joined;
  visit([&](const Interface& interface, const Pair& pair) {
    const int first = joined.firstOf(interface, pair.pair);
    for (int side = 0; side < interface.sides(); ++side) {
      for (const auto& entry : interface.trace(side).row(pair.pair))
        joined.sets.join(first, joined.number({interface.body(side), entry.node}));
    }
  });
  std::vector<Cluster> clusters(joined.sets.size());
  for (const auto& [node, number] : joined.numbers) {
    Cluster& cluster = clusters[joined.sets.root(number)];
    ++cluster.nodes;
    if (isHeld(node)) ++cluster.ends;
  }
  visit([&](const Interface& interface, const Pair& pair) {
    Cluster& cluster = clusters[joined.sets.root(joined.firstOf(interface, pair.pair))];
    ++(interface.sides() == 2 ? cluster.links : cluster.ends);
    cluster.pairs.push_back(pair);
  });
  for (Cluster& cluster : clusters) {
    if (cluster.nodes > 0) clusters_.push_back(std::move(cluster));
  }
}

}  // namespace harmos::assembly
