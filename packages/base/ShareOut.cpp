#include <harmos/base/ShareOut.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace harmos::base {
namespace {

// Of the cost of a piece: how much more its owner may have to do than others and keep it.
constexpr double hardlyMore = 0.1;

}  // namespace

std::vector<int> shareOut(const std::vector<double>& cost, std::vector<double> load, const std::vector<int>& owner) {
  std::vector<std::size_t> order(cost.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
  std::vector<int> rank(cost.size());
  for (const std::size_t piece : order) {
    auto taker = std::min_element(load.begin(), load.end());
    if (!owner.empty() && load[owner[piece]] <= *taker + hardlyMore * cost[piece]) taker = load.begin() + owner[piece];
    *taker += cost[piece];
    rank[piece] = static_cast<int>(taker - load.begin());
  }
  return rank;
}

}  // namespace harmos::base
