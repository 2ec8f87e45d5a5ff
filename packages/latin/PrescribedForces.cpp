#include <harmos/latin/PrescribedForces.hpp>

#include <algorithm>

#include <harmos/latin/InterfaceMass.hpp>

namespace harmos::latin {

std::vector<double> prescribedForces(const assembly::Interface& interface, int dimension, int step) {
  const auto pairs = static_cast<std::size_t>(interface.pairs());
  const std::vector<laws::LocalLine> lines(pairs);
  std::vector<laws::LocalState> states(pairs);
  interface.law->solve(step, {interface.pairs(), lines.data(), interface.gap.data(), nullptr, nullptr, states.data()});
  std::vector<double> traction;
  for (std::size_t p = 0; p < pairs; ++p) {
    base::Vector3 f = states[p].traction;
    if (interface.law->frame() == laws::Frame::interface) f = base::toGlobal(interface.frame[p], f);
    traction.insert(traction.end(), f.begin(), f.begin() + dimension);
  }
  std::vector<double> force(traction.size());
  applyMass(interface, dimension, traction.data(), force.data());
  return force;
}

}  // namespace harmos::latin
