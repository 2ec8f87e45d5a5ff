#include <harmos/scene/detail/HeldJump.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace harmos::scene {
namespace {

// Weight of a node at a point that is none, component of a direction that is none, and relative difference of
// displacements, but for round-off.
constexpr double noWeight = 1e-9, noPart = 1e-6, equal = 1e-6;

constexpr base::Frame axesOfSpace{{{{{1.0, 0.0, 0.0}}}, {{{0.0, 1.0, 0.0}}}, {{{0.0, 0.0, 1.0}}}}};

void fill(Span& span) {
  for (const base::Vector3& axis : axesOfSpace) span.add(axis);
}

}  // namespace

HeldJump::HeldJump(const HeldNodes& held, const assembly::Interface& interface, int pair, int components) {
  if (components == 2) free_.add(axesOfSpace[2]);
  for (int side = 0; side < interface.sides() && !free_.isSpace(); ++side) feel(held, interface, pair, side);
}

void HeldJump::feel(const HeldNodes& held, const assembly::Interface& interface, int pair, int side) {
  const int body = interface.body(side);
  bool isFelt = false;
  for (const auto& entry : interface.trace(side).row(pair)) {
    if (std::abs(entry.weight) <= noWeight) continue;
    isFelt = true;
    const std::vector<Holding>& holdings = held.of(body, entry.node);
    if (holdings.empty()) return fill(free_);
    Node node{side, side == 0 ? -entry.weight : entry.weight, held.axes(body, entry.node), holdings};
    Span ofNode;
    for (const HeldAxis& axis : node.axes) ofNode.add(axis.direction);
    for (const base::Vector3& direction : ofNode.complement(axesOfSpace)) free_.add(direction);
    if (free_.isSpace()) return;
    steps_ = holdings.front().displacement->size();
    nodes_.push_back(std::move(node));
  }
  if (!isFelt) fill(free_);  // a copy of a point
}

double HeldJump::displacement(const Node& node, const base::Vector3& direction, std::size_t step) {
  double sum = 0.0;
  for (const HeldAxis& axis : node.axes) sum += dot(direction, axis.direction) * axis.displacement[step];
  return sum;
}

std::vector<double> HeldJump::along(const base::Vector3& direction) const {
  std::vector<double> jump(steps_, 0.0);
  for (const Node& node : nodes_) {
    for (std::size_t t = 0; t < steps_; ++t) jump[t] += node.weight * displacement(node, direction, t);
  }
  return jump;
}

std::vector<double> HeldJump::uncertainty(const base::Vector3& direction) const {
  std::vector<double> result(steps_, 0.0);
  for (std::size_t t = 0; t < steps_; ++t) {
    double size = 0.0;
    std::array<std::vector<double>, 2> ofSides;
    for (const Node& node : nodes_) {
      for (const HeldAxis& axis : node.axes) size = std::max(size, std::abs(axis.displacement[t]));
      ofSides[static_cast<std::size_t>(node.side)].push_back(displacement(node, direction, t));
    }
    result[t] = equal * size;
    for (const auto& ofSide : ofSides) {
      if (ofSide.empty()) continue;
      const auto [least, most] = std::minmax_element(ofSide.begin(), ofSide.end());
      result[t] += *most - *least;
    }
  }
  return result;
}

std::vector<int> HeldJump::holders(const base::Vector3& direction) const {
  std::set<int> found;
  for (const Node& node : nodes_) {
    for (const Holding& holding : node.holdings) {
      if (std::abs(dot(holding.direction, direction)) > noPart) found.insert(holding.interface);
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace harmos::scene
