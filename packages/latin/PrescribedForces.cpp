#include <harmos/latin/PrescribedForces.hpp>

#include <algorithm>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {

std::vector<laws::LocalState> prescribedStates(const assembly::Interface& interface, int step) {
  const std::vector<laws::LocalLine> lines(interface.pairs());
  std::vector<laws::LocalState> states(interface.pairs());
  interface.law->solve(step, {interface.pairs(), lines.data(), interface.gap.data(), nullptr, nullptr, states.data(),
                              interface.position.data()});
  return states;
}

std::vector<base::Vector3> prescribedTractions(const assembly::Interface& interface, int step) {
  const bool isGlobal = interface.law->frame() == laws::Frame::global;
  std::vector<base::Vector3> tractions;
  for (const laws::LocalState& state : prescribedStates(interface, step)) {
    tractions.push_back(isGlobal ? state.traction : base::toGlobal(interface.frame[tractions.size()], state.traction));
  }
  return tractions;
}

std::vector<double> prescribedForces(const assembly::Interface& interface, int dimension, int step) {
  std::vector<double> traction;
  for (const base::Vector3& f : prescribedTractions(interface, step)) {
    traction.insert(traction.end(), f.begin(), f.begin() + dimension);
  }
  std::vector<double> force(traction.size());
  applyMass(interface, dimension, traction.data(), force.data());
  return force;
}

}  // namespace harmos::latin
