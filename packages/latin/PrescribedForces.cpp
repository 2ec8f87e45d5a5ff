#include <harmos/latin/PrescribedForces.hpp>

#include <algorithm>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {

std::vector<laws::LocalState> prescribedStates(const assembly::Interface& interface, const std::vector<double>& times,
                                               int step) {
  const std::vector<laws::LocalLine> lines(interface.pairs());
  std::vector<laws::LocalState> states(interface.pairs());
  laws::NodeArrays nodes = interface.nodes(times, step);
  nodes.line = lines.data();
  nodes.state = states.data();
  interface.solve(step, nodes);
  return states;
}

std::vector<base::Vector3> prescribedTractions(const assembly::Interface& interface, const std::vector<double>& times,
                                               int step) {
  const bool isGlobal = interface.law->frame() == laws::Frame::global;
  std::vector<base::Vector3> tractions;
  for (const laws::LocalState& state : prescribedStates(interface, times, step)) {
    tractions.push_back(isGlobal ? state.traction : base::toGlobal(interface.frame[tractions.size()], state.traction));
  }
  return tractions;
}

std::vector<double> prescribedForces(const assembly::Interface& interface, const std::vector<double>& times,
                                     int dimension, int step) {
  std::vector<double> traction;
  for (const base::Vector3& f : prescribedTractions(interface, times, step)) {
    traction.insert(traction.end(), f.begin(), f.begin() + dimension);
  }
  std::vector<double> force(traction.size());
  applyMass(interface, dimension, traction.data(), force.data());
  return force;
}

}  // namespace harmos::latin
