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
    for (const End& end : joint.ends) {
      for (const std::size_t i : end.interfaces) isTold_[i] = true;
    }
    joints_.push_back(std::move(joint));
  }
}

const laws::FaceLaw* CoupledFaces::lawOf(std::size_t interface) const {
  return dynamic_cast<const laws::FaceLaw*>(assembly_.interfaces[interface].law.get());
}

bool CoupledFaces::isKnown(const Joint& joint, BodyGroups& groups) const {
  if (!joint.isRigid) return true;
  for (const End& end : joint.ends) {
    std::map<int, std::vector<base::Vector3>> places;  // of every group
    for (const std::size_t i : end.interfaces) {
      const Interface& interface = assembly_.interfaces[i];
      std::vector<base::Vector3>& own = places[groups.rootOf(interface.body1)];
      for (int p = 0; p < interface.pairs(); ++p) {
        own.push_back(interface.trace1.at(p, assembly_.bodies[interface.body1].nodes));
      }
    }
    for (const auto& [group, own] : places) {
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

bool CoupledFaces::joinRigid(const Joint& joint, BodyGroups& groups) const {
  const auto isOne = [&](const End& end) { return areOne(end, groups); };
  if (!joint.isRigid || std::all_of(joint.ends.begin(), joint.ends.end(), isOne)) return false;
  if (!isKnown(joint, groups)) return false;
  for (const End& end : joint.ends) {
    for (const std::size_t i : end.interfaces) groups.join(assembly_.interfaces[i].body1, bodyOf(end));
  }
  return true;
}

bool CoupledFaces::joinEnds(const Joint& joint, BodyGroups& groups) const {
  const std::size_t ends = joint.isToGround ? 1 : 2;
  if (!joint.bearsAll || joint.ends.size() != ends || !isKnown(joint, groups)) return false;
  if (!std::all_of(joint.ends.begin(), joint.ends.end(), [&](const End& end) { return areOne(end, groups); }))
    return false;
  const int first = bodyOf(joint.ends.front()), second = joint.isToGround ? -1 : bodyOf(joint.ends.back());
  if (groups.rootOf(first) == groups.rootOf(second)) return false;
  groups.join(first, second);
  return true;
}

std::vector<std::size_t> CoupledFaces::join(BodyGroups& groups) {
  // What one joins may make another one's bodies one.
  for (bool goesOn = true; goesOn;) {
    goesOn = false;
    for (const Joint& joint : joints_) {
      if (joinRigid(joint, groups)) goesOn = true;
      if (joinEnds(joint, groups)) goesOn = true;
    }
  }
  std::vector<std::size_t> untold;
  const auto isUntold = [&](const Joint& joint) { return !isKnown(joint, groups); };
  for (const Joint& joint : joints_) {
    if (!isUntold(joint)) continue;
    for (const End& end : joint.ends) untold.insert(untold.end(), end.interfaces.begin(), end.interfaces.end());
  }
  for (const std::size_t i : untold) isTold_[i] = false;
  joints_.erase(std::remove_if(joints_.begin(), joints_.end(), isUntold), joints_.end());
  return untold;
}

bool CoupledFaces::isWithinOne(const Joint& joint, const std::vector<int>& rigidBodyOf) const {
  const int first = rigidBodyOf[bodyOf(joint.ends.front())];
  const auto isOfFirst = [&](std::size_t i) { return rigidBodyOf[assembly_.interfaces[i].body1] == first; };
  return !joint.isToGround && std::all_of(joint.ends.begin(), joint.ends.end(), [&](const End& end) {
    return std::all_of(end.interfaces.begin(), end.interfaces.end(), isOfFirst);
  });
}

std::vector<statics::Coupling> CoupledFaces::couplings(const std::vector<statics::RigidBody>& rigid,
                                                       const std::vector<int>& rigidBodyOf) const {
  std::vector<statics::Coupling> couplings;
  for (const Joint& joint : joints_) {
    // What both ends feel cancels where they are of one body, and would be round-off.
    if (isWithinOne(joint, rigidBodyOf)) continue;
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
