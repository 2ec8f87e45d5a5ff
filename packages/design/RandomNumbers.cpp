#include <harmos/design/detail/RandomNumbers.hpp>

#include <cmath>
#include <numeric>

namespace harmos::design {

double RandomNumbers::fraction() {
  return std::ldexp(static_cast<double>(generator_() >> 11), -53);
}

std::vector<int> RandomNumbers::permutation(int count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t left = numbers.size(); left > 1; --left) {
    std::swap(numbers[left - 1], numbers[fraction() * static_cast<double>(left)]);
  }
  return numbers;
}

}  // namespace harmos::design
