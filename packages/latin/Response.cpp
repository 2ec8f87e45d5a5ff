#include <harmos/latin/Response.hpp>

#include <algorithm>

namespace harmos::latin {
namespace {

/// f [stress] that acts on side 1 at pair p: of the linear stage, or the prescribed one.
base::Vector3 tractionOf(const Iterate& state, int interfaceIndex, int begin, int p, int t) {
  base::Vector3 f{};
  const int dimension = state.layout().dimension();
  if (begin >= 0) {
    std::copy_n(state.traction()[t] + begin + p * dimension, dimension, f.begin());
    return f;
  }
  const assembly::Interface& interface = state.assembly().interfaces[interfaceIndex];
  const laws::LocalLine line;
  laws::LocalState local;
  interface.law->solve(t, {1, &line, interface.gap.data() + p, nullptr, nullptr, &local});
  const bool isGlobal = interface.law->frame() == laws::Frame::global;
  return isGlobal ? local.traction : base::toGlobal(interface.frame[p], local.traction);
}

}  // namespace

std::vector<double> DisplacementResponse::evaluate(const Iterate& state) const {
  std::vector<double> values(state.assembly().steps(), 0.0);
  for (const Node& node : nodes_) {
    if (!state.layout().owns(node.body)) continue;
    for (int t = 0; t < state.assembly().steps(); ++t) {
      values[t] += node.weight * dot(state.displacement(node.body, node.node, t), direction_);
    }
  }
  state.metric().sum(values);
  return values;
}

std::vector<double> ResultantResponse::evaluate(const Iterate& state) const {
  std::vector<double> values(state.assembly().steps(), 0.0);
  for (int i : interfaces_) {
    const assembly::Interface& interface = state.assembly().interfaces[i];
    if (!state.layout().owns(interface.body1)) continue;
    const int begin = state.layout().begin(i, 0);
    const auto& nodes = state.assembly().bodies[interface.body1].nodes;
    for (int p = 0; p < interface.pairs(); ++p) {
      const auto pair = static_cast<std::size_t>(p);
      const base::Vector3& direction = direction_.empty() ? interface.frame[pair][0] : direction_[0];
      base::Vector3 arm = direction;
      if (!centre_.empty()) {
        const base::Vector3& x = nodes[interface.node1[pair]];
        arm = cross(direction, {x[0] - centre_[0][0], x[1] - centre_[0][1], x[2] - centre_[0][2]});
      }
      for (int t = 0; t < state.assembly().steps(); ++t) {
        values[t] += interface.area[pair] * dot(tractionOf(state, i, begin, p, t), arm);
      }
    }
  }
  state.metric().sum(values);
  return values;
}

std::vector<double> PairResponse::evaluate(const Iterate& state) const {
  std::vector<double> values(state.assembly().steps(), 0.0);
  for (int i : interfaces_) {
    include(state.assembly().interfaces[i], pairFields(state, i), values);
  }
  return values;
}

void DissipationResponse::include(const assembly::Interface& interface, const PairFields& fields,
                                  std::vector<double>& values) const {
  if (!interface.law->dissipates()) return;
  double total = 0.0;
  for (int t = 0; t < fields.steps; ++t) {
    for (int p = 0; p < fields.pairs; ++p) {
      const base::Vector3& f = fields.traction[fields.at(t, p)];
      const base::Vector3& now = fields.jump[fields.at(t, p)];
      const base::Vector3 old = t > 0 ? fields.jump[fields.at(t - 1, p)] : base::Vector3{};
      total += interface.area[p] * (f[1] * (now[1] - old[1]) + f[2] * (now[2] - old[2]));
    }
    values[t] += total;
  }
}

void MaximumResponse::include(const assembly::Interface& interface, const PairFields& fields,
                              std::vector<double>& values) const {
  for (int t = 0; t < fields.steps; ++t) {
    double& largest = values[t];
    for (int p = 0; p < fields.pairs; ++p) {
      const base::Vector3& f = fields.traction[fields.at(t, p)];
      const base::Vector3& jump = fields.jump[fields.at(t, p)];
      double value = 0.0;
      switch (field_) {
        case Field::contactPressure:
          value = -f[0];
          break;
        case Field::normalTraction:
          value = std::abs(f[0]);
          break;
        case Field::tangentialTraction:
          value = base::tangentialNorm(f);
          break;
        case Field::opening:
          value = jump[0] + interface.gap[p];
          break;
        case Field::slip:
          value = base::tangentialNorm(jump);
          break;
      }
      largest = std::max(largest, value);
    }
  }
}

}  // namespace harmos::latin
