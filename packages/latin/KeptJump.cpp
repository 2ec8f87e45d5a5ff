#include <harmos/latin/KeptJump.hpp>

#include <map>

#include <harmos/laws/CoupledLaw.hpp>

namespace harmos::latin {
namespace {

void addSide(const assembly::Interface& interface, int side, int pair, const base::Vector3& weight,
             ResponseGradient& gradient) {
  for (const auto& entry : interface.trace(side).row(pair)) {
    gradient.nodes.push_back({interface.body(side), entry.node, entry.weight * weight});
  }
}

KeptJump keptBy(const assembly::Assembly& assembly, const std::vector<int>& interfaces, int step) {
  double area = 0.0;
  for (const int i : interfaces) {
    for (const double h : assembly.interfaces[i].area) area += h;
  }
  KeptJump kept{step, {}, {}};
  for (const int i : interfaces) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto& law = dynamic_cast<const laws::CoupledLaw&>(*interface.law);
    for (int p = 0; p < interface.pairs(); ++p) {
      const auto share = law.keptShare(interface.position[p], interface.frame[p][0], area);
      const base::Vector3 weight = interface.area[p] * share.ofJump;
      addSide(interface, 0, p, -1.0 * weight, kept.gradient);
      if (interface.sides() == 2) addSide(interface, 1, p, weight, kept.gradient);
      kept.force.pairs.push_back({i, p, share.ofForce});
    }
  }
  return kept;
}

}  // namespace

std::vector<KeptJump> keptJumps(const assembly::Assembly& assembly, int step) {
  std::vector<std::vector<int>> faces;
  std::vector<int> since;
  std::map<int, std::size_t> known;  // by number of the face
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const assembly::Interface& interface = assembly.interfaces[i];
    const auto* law = dynamic_cast<const laws::CoupledLaw*>(interface.law.get());
    const int keptSince = law != nullptr ? law->keepsJumpSince(step) : -1;
    if (keptSince < 0) continue;
    const auto of = interface.face < 0 ? known.end() : known.find(interface.face);
    if (of != known.end()) {
      faces[of->second].push_back(static_cast<int>(i));
      continue;
    }
    if (interface.face >= 0) known[interface.face] = faces.size();
    faces.push_back({static_cast<int>(i)});
    since.push_back(keptSince);
  }
  std::vector<KeptJump> result;
  for (std::size_t f = 0; f < faces.size(); ++f) result.push_back(keptBy(assembly, faces[f], since[f]));
  return result;
}

}  // namespace harmos::latin
