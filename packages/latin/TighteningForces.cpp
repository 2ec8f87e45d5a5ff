#include <harmos/latin/detail/NormalForces.hpp>

#include <map>
#include <numeric>

#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::latin {
namespace {

std::optional<double> normalForceOf(const assembly::Interface& interface, int step) {
  const auto* law = dynamic_cast<const laws::CoupledLaw*>(interface.law.get());
  return law == nullptr ? std::nullopt : law->normalForce(step);
}

}  // namespace

bool bringsNormalForce(const assembly::Interface& interface, int step) {
  return normalForceOf(interface, step).has_value();
}

void addNormalForces(const assembly::Assembly& assembly, int step,
                     const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add) {
  // A face may be several interfaces, between the pieces of parts that are cut.
  std::map<std::size_t, double> areas;
  const auto faceOf = [&](std::size_t i) {
    const int face = assembly.interfaces[i].face;
    return face < 0 ? i : assembly.interfaces.size() + static_cast<std::size_t>(face);
  };
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (bringsNormalForce(interface, step))
      areas[faceOf(i)] += std::accumulate(interface.area.begin(), interface.area.end(), 0.0);
  }
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto force = normalForceOf(interface, step);
    if (!force) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      const int body = interface.body(side);
      const auto& nodes = assembly.bodies[body].nodes;
      const double share = (side == 0 ? *force : -*force) / areas[faceOf(i)];
      for (int p = 0; p < interface.pairs(); ++p) {
        add(static_cast<std::size_t>(body), interface.trace(side).at(p, nodes),
            share * interface.area[p] * interface.frame[p][0]);
      }
    }
  }
}

void slideAlongNormals(const assembly::Assembly& assembly, int step, statics::RigidAssembly& rigid) {
  std::vector<statics::Joint> joints;
  for (statics::Joint joint : rigid.joints) {
    if (!bringsNormalForce(assembly.interfaces[joint.interface], step)) {
      joints.push_back(joint);
      continue;
    }
    joint.tractions = laws::AdmissibleTractions::components(false, true, true);
    const double arm = rigid.bodies[joint.body1 < 0 ? joint.body2 : joint.body1].size;
    for (const double offset : {-arm, arm}) {
      statics::Joint shifted = joint;
      shifted.place1 = joint.place1 + offset * joint.frame[0];
      shifted.place2 = joint.place2 + offset * joint.frame[0];
      joints.push_back(shifted);
    }
  }
  rigid.joints = std::move(joints);
}

}  // namespace harmos::latin
