#include <harmos/scene/Temperatures.hpp>

#include <harmos/scene/detail/TemperatureField.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

Temperatures::Temperatures(const Scene& scene, const mesh::Mesh& mesh, input::ErrorList& errors)
    : steps_(static_cast<int>(scene.times.size())) {
  const TemperatureContext context{mesh, scene.input.list("Mesh"), scene.path};
  for (const input::Parameters& list : scene.input.lists("Temperatures")) {
    errors.collect(list.where(), [&] {
      const std::shared_ptr<const TemperatureField> field = builtInTemperatures().create(list, context);
      for (const input::Parameters& part : scene.input.lists("Parts")) {
        if (concerns(list, part.name())) parts_[part.name()] = {field, list.number("Reference")};
      }
    });
  }
}

base::Matrix Temperatures::of(const mesh::Piece& piece) const {
  const auto part = parts_.find(piece.part);
  if (part == parts_.end()) return {};
  base::Matrix change(static_cast<int>(piece.nodes.size()), steps_);
  for (int t = 0; t < steps_; ++t) {
    for (int node = 0; node < change.numRows(); ++node) {
      change(node, t) = part->second.field->at(t, piece.nodes[node]) - part->second.reference;
    }
  }
  return change;
}

}  // namespace harmos::scene
