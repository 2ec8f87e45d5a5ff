#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace harmos::latin {

/// Groups of bodies that are joined, directly or through others. The ground, a body of negative number, may be one of
/// them.
class BodyGroups {
 public:
  /// Every body is a group of its own.
  explicit BodyGroups(std::size_t bodies) : parent_(bodies + 1) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The number of the group of a body; that of the ground is the number of bodies until it is joined.
  int rootOf(int body) {
    int root = body < 0 ? static_cast<int>(parent_.size()) - 1 : body;
    while (parent_[root] != root) root = parent_[root] = parent_[parent_[root]];
    return root;
  }
  /// Makes one group of those of two bodies.
  void join(int a, int b) { parent_[rootOf(a)] = rootOf(b); }

 private:
  std::vector<int> parent_;  // the ground is the last
};

}  // namespace harmos::latin
