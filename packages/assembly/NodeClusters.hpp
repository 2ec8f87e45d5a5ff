#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <harmos/assembly/Interface.hpp>

namespace harmos::assembly {

/// Nodes of bodies that pairs of interfaces join, those of one cluster over other nodes and pairs. Not collective.
class NodeClusters {
 public:
  /// Positions of a body and of one of its nodes.
  using Node = std::pair<int, int>;
  /// A pair of an interface.
  struct Pair {
    int interface;  ///< position among those given
    int pair;       ///< of the interface
  };
  /// Clusters of more pairs are not looked at: what is done with one takes dense algebra of its size.
  static constexpr std::size_t mostPairs = 60;
  /// What hangs together.
  struct Cluster {
    int nodes = 0;            ///< that pairs touch
    int links = 0;            ///< pairs between two bodies
    int ends = 0;             ///< pairs on the ground, and nodes that are held
    std::vector<Pair> pairs;  ///< in the order of the interfaces
    /// Whether the nodes may not tell the tractions of the pairs, no more than mostPairs, apart: these close in a ring,
    /// or end twice.
    bool mayHideTractions() const { return pairs.size() <= mostPairs && (links >= nodes || ends > 1); }
  };

  /// `takes`: whether the pairs of an interface, by its position, join nodes. `isHeld`: whether something else holds a
  /// node. Nothing of the arguments is kept.
  NodeClusters(const std::vector<Interface>& interfaces, const std::function<bool(int)>& takes,
               const std::function<bool(const Node&)>& isHeld);

  /// All of them, those of no nodes left out.
  const std::vector<Cluster>& all() const { return clusters_; }

 private:
  std::vector<Cluster> clusters_;
};

}  // namespace harmos::assembly
