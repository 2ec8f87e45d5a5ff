#include <harmos/probability/HatLine.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

namespace {

// Density of nodes where there is no probability, over the largest.
constexpr double leastDensity = 1e-3;
// How often what lies between two nodes is halved: nodes are far apart where there is little probability, and where
// there is more than this share it may be at one place.
constexpr int leastHalvings = 2, mostHalvings = 40;
constexpr double mostOfCell = 4.0 / HatLine::last;

/// The largest power of two that divides the number of a node that is neither end.
int stepOf(int node) {
  return node & -node;
}

bool isEnd(int node) {
  return node == 0 || node == HatLine::last;
}

/// Integrals of 1, xi and xi^2 over what lies between two places.
struct Moments {
  double of1 = 0.0, ofXi = 0.0, ofXi2 = 0.0;
};

/// Adds what lies between a and b, not to exceed which have the probabilities `below` and `up`.
void addBetween(double a, double b, double below, double up, int halved,
                const std::function<double(double)>& cumulative, Moments& sum) {
  const double probability = up - below;
  if (halved < (probability > mostOfCell ? mostHalvings : leastHalvings)) {
    const double half = 0.5 * (a + b), between = cumulative(half);
    addBetween(a, half, below, between, halved + 1, cumulative, sum);
    addBetween(half, b, between, up, halved + 1, cumulative, sum);
    return;
  }
  sum.of1 += probability;
  sum.ofXi += probability * (a + b) / 2.0;
  sum.ofXi2 += probability * (a * a + a * b + b * b) / 3.0;
}

}  // namespace

HatLine::HatLine(double from, double to, const std::function<double(double)>& cumulative) {
  const double cell = (to - from) / last;
  std::vector<double> density;
  for (int k = 0; k < last; ++k) {
    const double probability = cumulative(from + (k + 1) * cell) - cumulative(from + k * cell);
    density.push_back(std::cbrt(std::max(probability, 0.0)));
  }
  // Where there is no probability there are few nodes, but the line goes on.
  const double least = leastDensity * *std::max_element(density.begin(), density.end());
  double total = 0.0;
  for (double& value : density) total += value = std::max(value, least);
  germs_.push_back(from);
  double passed = 0.0;
  for (int k = 0; k < last; ++k) {
    const double share = density[k] / total * last;
    while (static_cast<int>(germs_.size()) < last && static_cast<double>(germs_.size()) <= passed + share)
      germs_.push_back(from + (k + (static_cast<double>(germs_.size()) - passed) / share) * cell);
    passed += share;
  }
  germs_.push_back(to);

  Moments sum;
  double below = 0.0;
  const auto keep = [&] {
    moments_[0].push_back(sum.of1);
    moments_[1].push_back(sum.ofXi);
    moments_[2].push_back(sum.ofXi2);
  };
  keep();
  for (std::size_t k = 0; k < last; ++k) {
    const double up = k + 1 < last ? cumulative(germs_[k + 1]) : 1.0;
    addBetween(germs_[k], germs_[k + 1], below, up, 0, cumulative, sum);
    below = up;
    keep();
  }
}

HatLine::HatLine(std::vector<double> germs) : germs_(std::move(germs)) {
  require(germs_.size() == last + 1 && std::is_sorted(germs_.begin(), germs_.end()),
          "A line of hats has " + std::to_string(last + 1) + " ascending nodes.");
}

std::optional<int> HatLine::parent(int node) {
  if (node == middle) return std::nullopt;
  if (isEnd(node)) return middle;
  const int step = stepOf(node);
  if (step == middle / 2) return node < middle ? 0 : last;
  return stepOf(node - step) == 2 * step ? node - step : node + step;
}

std::vector<int> HatLine::children(int node) {
  if (node == middle) return {0, last};
  if (node == 0) return {middle / 2};
  if (node == last) return {last - middle / 2};
  const int half = stepOf(node) / 2;
  return half > 0 ? std::vector<int>{node - half, node + half} : std::vector<int>{};
}

std::pair<int, int> HatLine::support(int node) {
  if (node == middle) return {0, last};
  if (node == 0) return {0, middle};
  if (node == last) return {middle, last};
  return {node - stepOf(node), node + stepOf(node)};
}

double HatLine::value(int node, double xi) const {
  if (node == middle) return 1.0;
  const auto [left, right] = support(node);
  const double at = std::clamp(xi, germs_.front(), germs_.back());
  if (at < germ(left) || at > germ(right)) return 0.0;
  if (at == germ(node)) return 1.0;
  return at < germ(node) ? (at - germ(left)) / (germ(node) - germ(left))
                         : (germ(right) - at) / (germ(right) - germ(node));
}

double HatLine::mean(int node) const {
  return product(node, middle);
}

double HatLine::product(int node, int other) const {
  const auto [left, right] = support(node);
  const auto [otherLeft, otherRight] = support(other);
  std::vector<int> breaks;
  for (const int at : {left, node, right, otherLeft, other, otherRight}) {
    if (at >= std::max(left, otherLeft) && at <= std::min(right, otherRight)) breaks.push_back(at);
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const int from = breaks[k], to = breaks[k + 1];
    const double a = germ(from), length = germ(to) - a;
    const auto difference = [&](std::size_t power) { return moments_[power][to] - moments_[power][from]; };
    // Both are linear in s = (xi - a) / length.
    const double s0 = difference(0), s1 = (difference(1) - a * s0) / length,
                 s2 = (difference(2) - 2.0 * a * difference(1) + a * a * s0) / (length * length);
    const double f = valueAtNode(node, from), df = valueAtNode(node, to) - f;
    const double g = valueAtNode(other, from), dg = valueAtNode(other, to) - g;
    sum += f * g * s0 + (f * dg + df * g) * s1 + df * dg * s2;
  }
  return sum;
}

}  // namespace harmos::probability
