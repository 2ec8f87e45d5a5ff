#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace harmos::base {

/// Sets of the numbers 0, 1, ..., each with a member that stands for it, which are joined one by one. Not collective.
/// Source: Tarjan, van Leeuwen, Worst-case analysis of set union algorithms (1984), doi:10.1145/62.2160 (path halving).
class DisjointSets {
 public:
  /// So many numbers, each a set of its own.
  explicit DisjointSets(std::size_t count = 0) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }

  /// How many numbers there are.
  std::size_t size() const { return above_.size(); }
  /// The next number, a set of its own.
  int add() {
    above_.push_back(static_cast<int>(above_.size()));
    return above_.back();
  }
  /// The member that stands for the set of a number.
  int root(int one) {
    while (above_[one] != one) one = above_[one] = above_[above_[one]];
    return one;
  }
  /// Makes one set of those of two numbers; what stands for that of `b` stands for it.
  void join(int a, int b) { above_[root(a)] = root(b); }

 private:
  std::vector<int> above_;
};

}  // namespace harmos::base
