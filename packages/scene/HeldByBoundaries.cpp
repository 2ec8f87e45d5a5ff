#include <harmos/scene/detail/HeldByBoundaries.hpp>

#include <array>
#include <cmath>

#include <harmos/base/Error.hpp>
#include <harmos/laws/AffineComponent.hpp>
#include <harmos/laws/FieldLaw.hpp>
#include <harmos/laws/TurnedLaw.hpp>

namespace harmos::scene {
namespace {

/// The components of an affine law that are rigid at all load steps.
std::array<bool, 3> rigidComponents(const laws::InterfaceLaw& law, int components, int steps) {
  std::array<bool, 3> rigid = {true, true, components == 3};
  for (int t = 0; t < steps; ++t) {
    const auto affine = laws::affineComponents(law, t);
    for (std::size_t c = 0; c < 3; ++c) rigid[c] = rigid[c] && std::isinf(affine[c].stiffness);
  }
  return rigid;
}

std::vector<mesh::InterfaceSurface> surfacesOf(const input::Parameters& list, const mesh::InterfaceFinder& finder) {
  try {
    if (list.has("Side Set")) return finder.onSideSet(list.name(), list.text("Side Set"));
    return finder.onNodeSet(list.name(), list.text("Node Set"), list.has("Part") ? list.text("Part") : "");
  } catch (const base::Error&) {
    return {};
  }
}

}  // namespace

mortar::HeldDirections heldByBoundaries(const Scene& scene, int components, const std::vector<mesh::Piece>& pieces,
                                        const mesh::InterfaceFinder& finder) {
  mortar::HeldDirections held;
  for (const input::Parameters& list : scene.input.lists("Boundaries")) {
    const laws::InterfaceLaw& law = *laws::roleOf<laws::InterfaceLaw>(*scene.laws.at(list.name()));
    if (!law.isAffine() || law.prescribesTraction()) continue;
    const auto* turned = dynamic_cast<const laws::TurnedLaw*>(&law);
    const auto rigid = rigidComponents(law, components, static_cast<int>(scene.times.size()));
    for (const mesh::InterfaceSurface& surface : surfacesOf(list, finder)) {
      for (int p = 0; p < surface.pairs(); ++p) {
        const base::Frame frame = turned == nullptr ? surface.frame[p] : turned->axesAt(surface.position[p]);
        auto& directions = held[pieces[surface.piece1].nodes[surface.trace1.node(p)]];
        for (std::size_t c = 0; c < 3; ++c) {
          if (!rigid[c]) continue;
          base::Vector3 axis{};
          axis[c] = 1.0;
          directions.push_back(law.frame() == laws::Frame::interface ? frame[c] : axis);
        }
      }
    }
  }
  return held;
}

}  // namespace harmos::scene
