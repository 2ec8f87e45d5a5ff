#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace harmos::design {

/// Random numbers that a seed reproduces with every compiler; the distributions of the standard library do not.
class RandomNumbers {
 public:
  explicit RandomNumbers(int seed) : generator_(static_cast<std::uint64_t>(seed)) {}

  /// Uniform, 0 <= value < 1.
  double fraction();
  /// The numbers 0 to count - 1 in a random order.
  std::vector<int> permutation(int count);

 private:
  std::mt19937_64 generator_;
};

}  // namespace harmos::design
