#include <harmos/latin/Response.hpp>

#include <algorithm>

#include <harmos/latin/Dissipation.hpp>

namespace harmos::latin {
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
    const auto& nodes = state.assembly().bodies[interface.body1].nodes;
    std::vector<base::Vector3> arms;
    for (int p = 0; p < interface.pairs(); ++p) {
      const base::Vector3& direction = direction_.empty() ? interface.frame[p][0] : direction_[0];
      arms.push_back(centre_.empty() ? direction : cross(direction, interface.trace1.at(p, nodes) - centre_[0]));
    }
    for (int t = 0; t < state.assembly().steps(); ++t) {
      const std::vector<base::Vector3> tractions = state.tractions(i, t);
      for (int p = 0; p < interface.pairs(); ++p) values[t] += interface.area[p] * dot(tractions[p], arms[p]);
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
  const std::vector<double> lost = lostWork(interface, fields);
  for (int t = 0; t < fields.steps; ++t) {
    for (int p = 0; p < fields.pairs; ++p) values[t] += interface.area[p] * lost[fields.at(t, p)];
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
