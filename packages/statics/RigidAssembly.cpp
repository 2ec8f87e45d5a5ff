#include <harmos/statics/RigidAssembly.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::statics {
namespace {

// Over the largest value of a coupling.
constexpr double roundOff = 1e-12;

void addWork(const RigidAssembly& assembly, int body, const Wrench& wrench, std::vector<WorkTerm>& terms) {
  const base::Vector3& force = wrench.force;
  const base::Vector3 moment = (1.0 / assembly.bodies[body].size) * wrench.moment;
  const int first = assembly.motions() * body;
  if (assembly.dimension == 2) {
    terms.insert(terms.end(), {{first, force[0]}, {first + 1, force[1]}, {first + 2, moment[2]}});
    return;
  }
  for (int c = 0; c < 3; ++c) {
    terms.push_back({first + c, force[c]});
    terms.push_back({first + 3 + c, moment[c]});
  }
}

void addWork(const RigidAssembly& assembly, int body, const base::Vector3& place, const base::Vector3& force,
             std::vector<WorkTerm>& terms) {
  if (body < 0) return;
  addWork(assembly, body, {force, base::cross(place - assembly.bodies[body].centre, force)}, terms);
}

}  // namespace

base::Vector3 jumpOf(const Joint& joint, const std::vector<RigidBody>& bodies, const std::vector<Motion>& motions) {
  base::Vector3 jump{};
  if (joint.body2 >= 0) jump = displacementOf(bodies[joint.body2], motions[joint.body2], joint.place2);
  if (joint.body1 >= 0) jump = jump - displacementOf(bodies[joint.body1], motions[joint.body1], joint.place1);
  return base::toFrame(joint.frame, jump);
}

std::vector<WorkTerm> workOf(const RigidAssembly& assembly, const Joint& joint, const base::Vector3& direction) {
  std::vector<WorkTerm> terms;
  addWork(assembly, joint.body1, joint.place1, direction, terms);
  const std::size_t ofBody1 = terms.size();
  addWork(assembly, joint.body2, joint.place2, -1.0 * direction, terms);
  if (joint.body1 != joint.body2) return terms;
  // One column must not name a row twice.
  for (std::size_t i = 0; i < ofBody1; ++i) terms[i].value += terms[ofBody1 + i].value;
  terms.resize(ofBody1);
  return terms;
}

std::vector<WorkTerm> workOf(const RigidAssembly& assembly, const Coupling& coupling) {
  std::vector<WorkTerm> all, terms;
  for (const auto& [body, wrench] : coupling.wrenches) addWork(assembly, body, wrench, all);
  double largest = 0.0;
  for (const WorkTerm& term : all) largest = std::max(largest, std::abs(term.value));
  for (const WorkTerm& term : all) {
    if (std::abs(term.value) > roundOff * largest) terms.push_back({term.index, term.value / largest});
  }
  return terms;
}

std::vector<Motion> motionsOf(const RigidAssembly& assembly, const std::vector<double>& values) {
  std::vector<Motion> motions(assembly.bodies.size());
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const double* mine = values.data() + b * static_cast<std::size_t>(assembly.motions());
    const double size = assembly.bodies[b].size;
    if (assembly.dimension == 2) {
      motions[b] = {{mine[0], mine[1], 0.0}, {0.0, 0.0, mine[2] / size}};
    } else {
      motions[b] = {{mine[0], mine[1], mine[2]}, {mine[3] / size, mine[4] / size, mine[5] / size}};
    }
  }
  return motions;
}

}  // namespace harmos::statics
