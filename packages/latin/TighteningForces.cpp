#include <harmos/latin/detail/TighteningForces.hpp>

#include <map>
#include <numeric>

#include <harmos/laws/CoupledLaw.hpp>
#include <harmos/mesh/InterfaceFrame.hpp>

namespace harmos::latin {
namespace {

const laws::CoupledLaw* tightenedLaw(const assembly::Interface& interface, int step) {
  const auto* law = dynamic_cast<const laws::CoupledLaw*>(interface.law.get());
  return law != nullptr && law->tighteningForce(step) ? law : nullptr;
}

/// What the force is made of at a pair; `area`: of the face.
laws::CoupledLaw::KeptShare shareOf(const laws::CoupledLaw& law, const assembly::Interface& interface, int pair,
                                    double area) {
  return law.keptShare(interface.position[pair], interface.frame[pair][0], area);
}

}  // namespace

bool isTightened(const assembly::Interface& interface, int step) {
  return tightenedLaw(interface, step) != nullptr;
}

void addTighteningForces(const assembly::Assembly& assembly, int step,
                         const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add) {
  // A face may be several interfaces, between the pieces of parts that are cut.
  std::map<std::size_t, double> areas;
  const auto faceOf = [&](std::size_t i) {
    const int face = assembly.interfaces[i].face;
    return face < 0 ? i : assembly.interfaces.size() + static_cast<std::size_t>(face);
  };
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    if (isTightened(interface, step))
      areas[faceOf(i)] += std::accumulate(interface.area.begin(), interface.area.end(), 0.0);
  }
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const laws::CoupledLaw* law = tightenedLaw(interface, step);
    if (law == nullptr) continue;
    for (int side = 0; side < interface.sides(); ++side) {
      const int body = interface.body(side);
      const auto& nodes = assembly.bodies[body].nodes;
      const double force = side == 0 ? *law->tighteningForce(step) : -*law->tighteningForce(step);
      for (int p = 0; p < interface.pairs(); ++p) {
        add(static_cast<std::size_t>(body), interface.trace(side).at(p, nodes),
            force * interface.area[p] * shareOf(*law, interface, p, areas[faceOf(i)]).ofJump);
      }
    }
  }
}

void slideAlongForces(const assembly::Assembly& assembly, int step, statics::RigidAssembly& rigid) {
  std::vector<statics::Joint> joints;
  for (statics::Joint joint : rigid.joints) {
    const assembly::Interface& interface = assembly.interfaces[joint.interface];
    const laws::CoupledLaw* law = tightenedLaw(interface, step);
    if (law == nullptr) {
      joints.push_back(joint);
      continue;
    }
    const base::Vector3 along = shareOf(*law, interface, joint.pair, 1.0).ofForce;
    joint.frame = mesh::frameFromNormal(along, assembly.dimension);
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
