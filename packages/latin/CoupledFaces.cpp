#include <harmos/latin/detail/CoupledFaces.hpp>

#include <algorithm>
#include <array>
#include <map>

#include <harmos/latin/InterfaceMass.hpp>
#include <harmos/latin/detail/FixedPlaces.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::Interface;

/// The law of an interface, if it says what it bears of the resultant on its face.
const laws::FaceLaw* tellingLaw(const Interface& interface, int step) {
  if (interface.sides() != 1 || interface.pairs() == 0) return nullptr;
  const auto* law = dynamic_cast<const laws::FaceLaw*>(interface.law.get());
  return law != nullptr && law->face() && law->resultants(step) ? law : nullptr;
}

/// Calls `use` with the place and the force on the body of every pair, under tractions [stress] that the place gives.
template <class Traction, class Use>
void forEachForce(const Assembly& assembly, const Interface& interface, const Traction& traction, const Use& use) {
  const int dimension = assembly.dimension;
  std::vector<double> tractions, forces(static_cast<std::size_t>(interface.pairs() * dimension));
  for (int p = 0; p < interface.pairs(); ++p) {
    const base::Vector3 t = traction(interface.position[p]);
    tractions.insert(tractions.end(), t.begin(), t.begin() + dimension);
  }
  applyMass(interface, dimension, tractions.data(), forces.data());
  for (int p = 0; p < interface.pairs(); ++p) {
    base::Vector3 force{};
    std::copy_n(forces.begin() + p * dimension, dimension, force.begin());
    use(interface.trace1.at(p, assembly.bodies[interface.body1].nodes), force);
  }
}

}  // namespace

CoupledFaces::CoupledFaces(const Assembly& assembly, int step)
    : assembly_(assembly), isTold_(assembly.interfaces.size(), false) {
  // A face may be several interfaces, of pieces and of both ends.
  std::map<std::size_t, Joint> joints;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const Interface& interface = assembly.interfaces[i];
    const laws::FaceLaw* law = tellingLaw(interface, step);
    if (law == nullptr) continue;
    Joint& joint =
        joints[interface.face < 0 ? i : assembly.interfaces.size() + static_cast<std::size_t>(interface.face)];
    if (joint.ends.empty()) {
      const auto components = *law->resultants(step);
      for (const int c : law->face()->components()) {
        if (components[static_cast<std::size_t>(c)].isBorne) joint.borne.push_back(static_cast<std::size_t>(c));
      }
      joint.bearsAll = joint.borne.size() == law->face()->components().size();
      joint.isRigid = !law->leavesFaceFree();
      joint.isToGround = law->onOtherFace() == nullptr;
    }
    const auto end = std::find_if(joint.ends.begin(), joint.ends.end(),
                                  [&](const End& one) { return one.face == law->face().get(); });
    if (end == joint.ends.end()) {
      joint.ends.push_back({law->face().get(), {i}});
    } else {
      end->interfaces.push_back(i);
    }
  }
  for (auto& [number, joint] : joints) {
    if (joint.isRigid && !fixesItsBodies(joint)) continue;
    for (const End& end : joint.ends) {
      for (const std::size_t i : end.interfaces) isTold_[i] = true;
    }
    joints_.push_back(std::move(joint));
  }
}

const laws::FaceLaw* CoupledFaces::lawOf(std::size_t interface) const {
  return dynamic_cast<const laws::FaceLaw*>(assembly_.interfaces[interface].law.get());
}

bool CoupledFaces::fixesItsBodies(const Joint& joint) const {
  for (const End& end : joint.ends) {
    std::map<int, std::vector<base::Vector3>> places;  // of every body
    for (const std::size_t i : end.interfaces) {
      const Interface& interface = assembly_.interfaces[i];
      for (int p = 0; p < interface.pairs(); ++p) {
        places[interface.body1].push_back(interface.trace1.at(p, assembly_.bodies[interface.body1].nodes));
      }
    }
    for (const auto& [body, own] : places) {
      if (!areFixed(own, assembly_.dimension)) return false;
    }
  }
  return true;
}

bool CoupledFaces::areOne(const End& end, BodyGroups& groups) const {
  const int group = groups.rootOf(bodyOf(end));
  return std::all_of(end.interfaces.begin(), end.interfaces.end(),
                     [&](std::size_t i) { return groups.rootOf(assembly_.interfaces[i].body1) == group; });
}

void CoupledFaces::join(BodyGroups& groups) const {
  for (const Joint& joint : joints_) {
    for (const End& end : joint.ends) {
      for (const std::size_t i : end.interfaces) {
        if (joint.isRigid) groups.join(assembly_.interfaces[i].body1, bodyOf(end));
      }
    }
  }
  // What one joins may make another one's bodies one.
  for (bool goesOn = true; goesOn;) {
    goesOn = false;
    for (const Joint& joint : joints_) {
      const std::size_t ends = joint.isToGround ? 1 : 2;
      if (!joint.bearsAll || joint.ends.size() != ends) continue;
      if (!std::all_of(joint.ends.begin(), joint.ends.end(), [&](const End& end) { return areOne(end, groups); }))
        continue;
      const int first = bodyOf(joint.ends.front()), second = joint.isToGround ? -1 : bodyOf(joint.ends.back());
      if (groups.rootOf(first) == groups.rootOf(second)) continue;
      groups.join(first, second);
      goesOn = true;
    }
  }
}

std::vector<statics::Coupling> CoupledFaces::couplings(const std::vector<statics::RigidBody>& rigid,
                                                       const std::vector<int>& rigidBodyOf) const {
  std::vector<statics::Coupling> couplings;
  for (const Joint& joint : joints_) {
    for (const std::size_t c : joint.borne) {
      std::map<int, statics::Wrench> wrenches;
      for (const End& end : joint.ends) {
        for (const std::size_t i : end.interfaces) {
          const Interface& interface = assembly_.interfaces[i];
          const int body = rigidBodyOf[interface.body1];
          if (body < 0) continue;
          statics::Wrench& sum = wrenches[body];
          forEachForce(
              assembly_, interface, [&](const base::Vector3& place) { return lawOf(i)->unitTractions(place)[c]; },
              [&](const base::Vector3& place, const base::Vector3& force) {
                sum.force = sum.force + force;
                sum.moment = sum.moment + base::cross(place - rigid[body].centre, force);
              });
        }
      }
      if (wrenches.empty()) continue;
      couplings.push_back(
          {static_cast<int>(joint.ends.front().interfaces.front()), {wrenches.begin(), wrenches.end()}});
    }
  }
  return couplings;
}

void addFaceForces(const Assembly& assembly, int step,
                   const std::function<void(std::size_t, const base::Vector3&, const base::Vector3&)>& add) {
  for (const Interface& interface : assembly.interfaces) {
    const laws::FaceLaw* law = tellingLaw(interface, step);
    if (law == nullptr) continue;
    const auto components = *law->resultants(step);
    if (std::all_of(components.begin(), components.end(), [](const auto& one) { return one.force == 0.0; })) continue;
    const auto traction = [&](const base::Vector3& place) {
      base::Vector3 sum{};
      const auto units = law->unitTractions(place);
      for (std::size_t c = 0; c < units.size(); ++c) sum = sum + components[c].force * units[c];
      return sum;
    };
    forEachForce(assembly, interface, traction, [&](const base::Vector3& place, const base::Vector3& force) {
      add(static_cast<std::size_t>(interface.body1), place, force);
    });
  }
}

}  // namespace harmos::latin
