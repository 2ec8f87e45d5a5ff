#include <harmos/latin/Response.hpp>

#include <algorithm>

#include <harmos/latin/InterfaceMass.hpp>
#include <harmos/latin/LawFields.hpp>

namespace harmos::latin {
namespace {

/// What a traction of a pair is multiplied with, times its area; `direction` and `centre` have one element or none.
base::Vector3 armAt(const assembly::Interface& interface, int pair, const std::vector<base::Vector3>& direction,
                    const std::vector<base::Vector3>& centre, const base::Vector3& place) {
  const base::Vector3& along = direction.empty() ? interface.frame[pair][0] : direction[0];
  return centre.empty() ? along : cross(along, place - centre[0]);
}

/// Where the forces of all pairs act on side 1.
std::vector<base::Vector3> placesOf(const assembly::Assembly& assembly, const assembly::Interface& interface) {
  std::vector<base::Vector3> places;
  for (int p = 0; p < interface.pairs(); ++p) {
    places.push_back(interface.trace1.at(p, assembly.bodies[interface.body1].nodes));
  }
  return placesOfForces(interface, std::move(places));
}

/// What reading the tractions of these interfaces takes.
ResponseWork workOf(const assembly::Assembly& assembly, const std::vector<int>& interfaces) {
  ResponseWork work;
  for (const int i : interfaces) {
    const assembly::Interface& interface = assembly.interfaces[i];
    (interface.sides() == 1 ? work.nodes : work.pairs) += interface.pairs();
  }
  return work;
}

}  // namespace

ResponseWork& ResponseWork::operator+=(const ResponseWork& other) {
  nodes += other.nodes;
  pairs += other.pairs;
  recovered += other.recovered;
  together = std::max(together, other.together);
  return *this;
}

ResponseWork DisplacementResponse::work(const assembly::Assembly& /*assembly*/) const {
  ResponseWork work;
  work.nodes = static_cast<double>(nodes_.size());
  return work;
}

ResponseWork ResultantResponse::work(const assembly::Assembly& assembly) const {
  return workOf(assembly, interfaces_);
}

ResponseWork PairResponse::work(const assembly::Assembly& assembly) const {
  return workOf(assembly, interfaces_);
}

std::vector<double> DisplacementResponse::evaluate(const Iterate& state) const {
  std::vector<double> values(state.assembly().steps(), 0.0);
  for (int t = 0; t < state.assembly().steps(); ++t) {
    for (const Node& node : nodes_) {
      if (!state.layout().owns(node.body)) continue;
      values[t] += node.weight * dot(state.displacement(node.body, node.node, t), direction_);
    }
  }
  state.metric().sum(values);
  return values;
}

std::optional<ResponseGradient> DisplacementResponse::gradient(const assembly::Assembly& /*assembly*/) const {
  ResponseGradient result;
  for (const Node& node : nodes_) result.nodes.push_back({node.body, node.node, node.weight * direction_});
  return result;
}

base::Vector3 ResultantResponse::arm(const assembly::Assembly& assembly, const assembly::Interface& interface,
                                     int pair) const {
  const base::Vector3 place = interface.mass.empty() ? interface.trace1.at(pair, assembly.bodies[interface.body1].nodes)
                                                     : placesOf(assembly, interface)[pair];
  return armAt(interface, pair, direction_, centre_, place);
}

base::Vector3 ResultantResponse::slope(const assembly::Assembly& assembly, const At& at) const {
  if (std::count(interfaces_.begin(), interfaces_.end(), at.interface) == 0) return {};
  const assembly::Interface& interface = assembly.interfaces[at.interface];
  return interface.area[at.pair] * arm(assembly, interface, at.pair);
}

std::vector<double> ResultantResponse::evaluate(const Iterate& state) const {
  std::vector<double> values(state.assembly().steps(), 0.0);
  for (int i : interfaces_) {
    const assembly::Interface& interface = state.assembly().interfaces[i];
    if (!state.layout().owns(interface.body1)) continue;
    std::vector<base::Vector3> arms = placesOf(state.assembly(), interface);
    for (int p = 0; p < interface.pairs(); ++p) arms[p] = armAt(interface, p, direction_, centre_, arms[p]);
    for (int t = 0; t < state.assembly().steps(); ++t) {
      const std::vector<base::Vector3> tractions = state.tractions(i, t);
      for (int p = 0; p < interface.pairs(); ++p) values[t] += interface.area[p] * dot(tractions[p], arms[p]);
    }
  }
  state.metric().sum(values);
  return values;
}

std::optional<ResponseGradient> ResultantResponse::gradient(const assembly::Assembly& assembly) const {
  ResponseGradient result;
  for (int i : interfaces_) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const std::vector<base::Vector3> places = placesOf(assembly, interface);
    for (int p = 0; p < interface.pairs(); ++p) {
      result.pairs.push_back({i, p, armAt(interface, p, direction_, centre_, places[p])});
    }
  }
  return result;
}

std::vector<double> PairResponse::evaluate(const Iterate& state) const {
  std::vector<double> values = begin(state.assembly().steps());
  for (int i : interfaces_) {
    include(state.assembly().interfaces[i], pairFields(state, i), values);
  }
  return finish(std::move(values));
}

std::vector<double> PairResponse::begin(int steps) const {
  return std::vector<double>(static_cast<std::size_t>(steps) * static_cast<std::size_t>(width()), start());
}

bool PairResponse::reads(int interface) const {
  return std::count(interfaces_.begin(), interfaces_.end(), interface) > 0;
}

base::Vector3 DissipationResponse::slope(const assembly::Assembly& assembly, const At& at) const {
  const assembly::Interface& interface = assembly.interfaces[at.interface];
  if (!reads(at.interface) || !interface.law->dissipates()) return {};
  const base::Vector3& n = interface.frame[at.pair][0];
  return interface.area[at.pair] * (at.jumpChange - dot(n, at.jumpChange) * n);
}

void DissipationResponse::include(const assembly::Interface& interface, const PairFields& fields,
                                  std::vector<double>& values) const {
  if (!interface.law->dissipates()) return;
  const std::vector<double> lost = lawFields(interface, fields).lost;
  for (int t = 0; t < fields.steps; ++t) {
    for (int p = 0; p < fields.pairs; ++p) values[t] += interface.area[p] * lost[fields.at(t, p)];
  }
}

base::Vector3 MaximumResponse::slope(const assembly::Assembly& assembly, const At& at) const {
  if (!reads(at.interface)) return {};
  const base::Frame& frame = assembly.interfaces[at.interface].frame[at.pair];
  const double normal = dot(frame[0], at.traction);
  const base::Vector3 shear = at.traction - normal * frame[0];
  switch (field_) {
    case Field::contactPressure:
      return -1.0 * frame[0];
    case Field::normalTraction:
      return (normal > 0.0 ? 1.0 : -1.0) * frame[0];
    case Field::tangentialTraction:
      return base::norm(shear) > 0.0 ? shear : frame[1];
    case Field::opening:
    case Field::slip:
      break;
  }
  return {};
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
          value = jump[0] + (interface.sides() == 2 ? interface.gap[p] : 0.0);
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
