#include <harmos/scene/detail/HeldNodes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <harmos/base/DisjointSets.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/scene/detail/AskedJumps.hpp>

namespace harmos::scene {
namespace {

// Length of what is left of a unit vector in the span of others, and relative difference of values, that is round-off.
constexpr double dependent = 1e-6, equal = 1e-6;

using Displacements = std::array<std::shared_ptr<const std::vector<double>>, 3>;

/// Of the components, in the frame of a law that is affine at every place, that do not depend on the traction; null:
/// not at every load step.
Displacements heldComponents(const laws::InterfaceLaw& law, const base::Vector3& place, int steps) {
  std::array<std::vector<double>, 3> values;
  for (int t = 0; t < steps; ++t) {
    const auto fixed = fixedJump(law, t, place);
    for (std::size_t c = 0; c < 3; ++c) {
      if (fixed[c]) values[c].push_back(-*fixed[c]);  // the ground is side 2 and at rest
    }
  }
  Displacements result;
  for (std::size_t c = 0; c < 3; ++c) {
    if (values[c].size() == static_cast<std::size_t>(steps)) {
      result[c] = std::make_shared<const std::vector<double>>(std::move(values[c]));
    }
  }
  return result;
}

/// Adds a holding to the axes; where it depends on them already, returns the conflict, if there is one.
std::optional<Conflict> combine(const Holding& holding, std::vector<HeldAxis>& axes) {
  base::Vector3 rest = holding.direction;
  std::vector<double> displacement = *holding.displacement;
  const HeldAxis* nearest = nullptr;
  for (const HeldAxis& axis : axes) {
    const double along = dot(holding.direction, axis.direction);
    rest = rest - along * axis.direction;
    for (std::size_t t = 0; t < displacement.size(); ++t) displacement[t] -= along * axis.displacement[t];
    if (nearest == nullptr || std::abs(along) > std::abs(dot(holding.direction, nearest->direction))) nearest = &axis;
  }
  const double length = norm(rest);
  if (length > dependent) {
    for (double& value : displacement) value /= length;
    axes.push_back({holding.interface, (1.0 / length) * rest, std::move(displacement)});
    return std::nullopt;
  }
  for (std::size_t t = 0; t < displacement.size(); ++t) {
    double size = std::abs((*holding.displacement)[t]);
    for (const HeldAxis& axis : axes) size = std::max(size, std::abs(axis.displacement[t]));
    if (std::abs(displacement[t]) <= equal * size) continue;
    Conflict conflict;
    conflict.holding = holding;
    conflict.other = nearest->interface;
    conflict.step = static_cast<int>(t);
    conflict.expected = (*holding.displacement)[t] - displacement[t];
    return conflict;
  }
  return std::nullopt;
}

}  // namespace

HeldNodes::HeldNodes(const std::vector<assembly::Interface>& interfaces, const std::vector<int>& nodes, int dimension,
                     int steps)
    : interfaces_(interfaces), dimension_(dimension), steps_(steps) {
  int count = 0;
  for (const int ofBody : nodes) {
    first_.push_back(count);
    count += ofBody;
  }
  holdings_.resize(count);
  representative_.resize(count);
  bond();
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const assembly::Interface& interface = interfaces[i];
    if (interface.sides() == 1 && interface.trace1.isSelection() &&
        laws::roleOf<laws::InterfaceLaw>(*interface.law)->isAffine() && !interface.law->prescribesTraction()) {
      hold(static_cast<int>(i));
    }
  }
}

void HeldNodes::bond() {
  base::DisjointSets bonded(representative_.size());
  for (const assembly::Interface& interface : interfaces_) {
    if (interface.sides() != 2 || !interface.law->bonds()) continue;
    if (!interface.trace1.isSelection() || !interface.trace2.isSelection()) continue;
    for (int p = 0; p < interface.pairs(); ++p) {
      bonded.join(first_[interface.body1] + interface.trace1.node(p),
                  first_[interface.body2] + interface.trace2.node(p));
    }
  }
  for (std::size_t node = 0; node < representative_.size(); ++node) {
    representative_[node] = bonded.root(static_cast<int>(node));
  }
}

void HeldNodes::hold(int interfaceIndex) {
  const assembly::Interface& interface = interfaces_[interfaceIndex];
  const bool isLocal = interface.law->frame() == laws::Frame::interface;
  Displacements held;
  for (int p = 0; p < interface.pairs(); ++p) {
    if (p == 0 || !interface.law->isAffine()) held = heldComponents(*interface.law, interface.position[p], steps_);
    auto& holdings = holdings_[representative_[first_[interface.body1] + interface.trace1.node(p)]];
    for (int c = 0; c < dimension_; ++c) {
      if (!held[c]) continue;
      base::Vector3 axis{};
      axis[c] = 1.0;
      holdings.push_back(
          {interfaceIndex, interface.body1, interface.trace1.node(p), isLocal ? interface.frame[p][c] : axis, held[c]});
    }
  }
}

const std::vector<Holding>& HeldNodes::of(int body, int node) const {
  return holdings_[representative_[first_[body] + node]];
}

std::vector<HeldAxis> HeldNodes::axes(int body, int node) const {
  std::vector<HeldAxis> axes;
  for (const Holding& holding : of(body, node)) combine(holding, axes);
  return axes;
}

std::vector<Conflict> HeldNodes::conflicts() const {
  std::vector<Conflict> conflicts;
  for (const std::vector<Holding>& holdings : holdings_) {
    std::vector<HeldAxis> axes;
    std::set<std::pair<int, int>> reported;
    for (const Holding& holding : holdings) {
      const auto conflict = combine(holding, axes);
      if (conflict && reported.insert({holding.interface, conflict->other}).second) conflicts.push_back(*conflict);
    }
  }
  return conflicts;
}

}  // namespace harmos::scene
