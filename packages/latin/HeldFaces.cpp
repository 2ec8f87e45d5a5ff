#include <harmos/latin/detail/HeldFaces.hpp>

#include <algorithm>
#include <cmath>
#include <map>

#include <harmos/latin/detail/AdmittedTractions.hpp>
#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {
namespace {

using assembly::Assembly;
using assembly::Interface;
using assembly::NodeClusters;

// Of the largest: unit tractions whose products have a lower eigenvalue depend on each other.
constexpr double roundOff = 1e-12;

bool isOnNodes(const Interface& interface) {
  return interface.mass.empty() && interface.trace1.isSelection() &&
         (interface.sides() == 1 || interface.trace2.isSelection());
}

/// The components that a law holds at all load steps.
std::vector<std::size_t> heldBy(const laws::FaceLaw& law, int steps) {
  std::vector<std::size_t> held;
  for (const int c : law.face()->components()) {
    const auto component = static_cast<std::size_t>(c);
    bool isHeld = true;
    for (int t = 0; t < steps && isHeld; ++t) isHeld = (*law.resultants(t))[component].isHeld;
    if (isHeld) held.push_back(component);
  }
  return held;
}

}  // namespace

HeldFaces::HeldFaces(const Assembly& assembly, const assembly::SearchDirection& searchDirection,
                     const EliminatedBoundaries& eliminated)
    : assembly_(assembly), searchDirection_(searchDirection), eliminated_(eliminated) {
  std::map<std::size_t, Face> found;
  for (std::size_t i = 0; i < assembly.interfaces.size(); ++i) {
    const Interface& interface = assembly.interfaces[i];
    const auto* law = dynamic_cast<const laws::FaceLaw*>(interface.law.get());
    if (law == nullptr || !law->face() || !law->resultants(0) || interface.sides() != 1) continue;
    Face& face = found[interface.face < 0 ? i : assembly.interfaces.size() + static_cast<std::size_t>(interface.face)];
    face.interfaces.push_back(i);
    if (face.interfaces.size() > 1) continue;
    face.held = heldBy(*law, assembly.steps());
    face.isRigid = !law->leavesFaceFree();
    face.centre = law->face()->centre();
  }
  for (auto& [key, face] : found) {
    if (!std::all_of(face.interfaces.begin(), face.interfaces.end(),
                     [&](std::size_t i) { return isOnNodes(assembly.interfaces[i]); }))
      continue;
    for (const std::size_t i : face.interfaces) {
      const Interface& interface = assembly.interfaces[i];
      for (int p = 0; p < interface.pairs(); ++p) {
        face.size = std::max(face.size, base::distance(interface.position[p], face.centre));
        face.area = std::max(face.area, interface.area[p]);
      }
    }
    makeOrthonormal(face);
    faces_.push_back(std::move(face));
  }
  number();
}

std::vector<base::Vector3> HeldFaces::tractionsAt(const Face& face, const Pair& pair) const {
  const Interface& interface = assembly_.interfaces[pair.interface];
  const auto units = dynamic_cast<const laws::FaceLaw&>(*interface.law).unitTractions(interface.position[pair.pair]);
  std::vector<base::Vector3> result;
  for (const std::size_t c : face.held) result.push_back(std::sqrt(interface.area[pair.pair]) * units[c]);
  return result;
}

void HeldFaces::makeOrthonormal(Face& face) const {
  const int count = static_cast<int>(face.held.size());
  if (count == 0) return;
  base::Matrix products(count, count);
  for (const std::size_t i : face.interfaces) {
    for (int p = 0; p < assembly_.interfaces[i].pairs(); ++p) {
      const auto tractions = tractionsAt(face, {static_cast<int>(i), p});
      for (int a = 0; a < count; ++a) {
        for (int b = 0; b < count; ++b) products(a, b) += base::dot(tractions[a], tractions[b]);
      }
    }
  }
  std::vector<double> scale;  // moments are other numbers than forces
  for (int a = 0; a < count; ++a) scale.push_back(1.0 / std::sqrt(products(a, a)));
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < count; ++b) products(a, b) *= scale[a] * scale[b];
  }
  const std::vector<double> values = symmetricEigen(products);
  const int dependent = static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](double value) { return value <= roundOff * values.back(); }));
  face.sums.shape(count, count - dependent);
  for (int j = dependent; j < count; ++j) {
    for (int a = 0; a < count; ++a) face.sums(a, j - dependent) = scale[a] * products(a, j) / std::sqrt(values[j]);
  }
}

void HeldFaces::number() {
  faceOf_.assign(assembly_.interfaces.size(), -1);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    for (const std::size_t i : faces_[f].interfaces) faceOf_[i] = static_cast<int>(f);
  }
}

void HeldFaces::keep(const std::vector<bool>& isKept) {
  std::vector<Face> kept;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (isKept[f]) kept.push_back(std::move(faces_[f]));
  }
  faces_ = std::move(kept);
  number();
}

std::vector<base::Vector3> HeldFaces::unitsAt(const Face& face, const Pair& pair) const {
  const auto tractions = tractionsAt(face, pair);
  std::vector<base::Vector3> result(face.fields());
  for (int j = 0; j < face.fields(); ++j) {
    for (std::size_t a = 0; a < tractions.size(); ++a) result[j] = result[j] + face.sums[j][a] * tractions[a];
  }
  return result;
}

std::vector<base::Vector3> HeldFaces::axesOf(const Pair& pair) const {
  const Interface& interface = assembly_.interfaces[pair.interface];
  if (const int f = faceOf_[pair.interface]; f >= 0) {
    const base::Frame axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    if (!faces_[f].isRigid) return {};
    return {axes.begin(), axes.begin() + assembly_.dimension};
  }
  const double compliance = 1.0 / searchDirection_.of(pair.interface)[pair.pair];
  auto axes = rigidAxes(interface, pair.pair, assembly_.dimension, 0, compliance);
  // What is eliminated holds alike at all load steps.
  for (int t = 1; t < assembly_.steps() && !eliminated_.contains(pair.interface); ++t) {
    auto others = rigidAxes(interface, pair.pair, assembly_.dimension, t, compliance);
    if (others.size() < axes.size()) axes = std::move(others);
  }
  return axes;
}

NodeClusters HeldFaces::clusters(bool withFaces) const {
  const auto takes = [&](int i) {
    if (eliminated_.contains(i)) return true;
    if (!withFaces || faces_.empty()) return false;
    const Interface& interface = assembly_.interfaces[i];
    return faceOf_[i] >= 0 ||
           (interface.law->isAffine() && !interface.law->prescribesTraction() && isOnNodes(interface));
  };
  return {assembly_.interfaces, takes, [](const NodeClusters::Node&) { return false; }};
}

}  // namespace harmos::latin
