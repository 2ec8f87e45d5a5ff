#include <harmos/scene/detail/BodyLoads.hpp>

#include <algorithm>

#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/ThermalLoad.hpp>

namespace harmos::scene {

namespace {

bool followsPlace(const input::Field& field) {
  return field.looksAt("x") || field.looksAt("y") || field.looksAt("z");
}

}  // namespace

BodyLoads::BodyLoads(const Scene& scene, elasticity::Kinematics kinematics, const Temperatures& temperatures,
                     input::ErrorList& errors)
    : scene_(scene), temperatures_(temperatures) {
  for (const input::Parameters& list : scene.input.lists("Loads")) {
    errors.collect(list.where(), [&] { loads_.emplace_back(&list, builtInVolumeLoads().create(list, kinematics)); });
  }
}

std::vector<const VolumeLoad*> BodyLoads::loadsOn(const std::string& part) const {
  std::vector<const VolumeLoad*> found;
  for (const auto& [list, load] : loads_) {
    if (concerns(*list, part)) found.push_back(load.get());
  }
  return found;
}

base::Matrix BodyLoads::of(const elasticity::ElasticPart& body,
                           const std::optional<std::array<input::Field, 3>>& bodyForce) const {
  const int dofs = elasticity::componentsOf(body.kinematics) * static_cast<int>(body.piece.nodes.size());
  const int steps = static_cast<int>(scene_.times.size());
  const std::vector<const VolumeLoad*> loads = loadsOn(body.piece.part);
  base::Matrix forces;
  if (bodyForce || !loads.empty()) {
    forces.shape(dofs, steps);
    const bool isUniform = !bodyForce || std::none_of(bodyForce->begin(), bodyForce->end(), followsPlace);
    if (!isUniform) {
      elasticity::BodyForce::addTo(forces, body, [&](int step, const base::Vector3& place) {
        return base::Vector3{(*bodyForce)[0](step, place), (*bodyForce)[1](step, place), (*bodyForce)[2](step, place)};
      });
    }
    const elasticity::BodyForce integrals(body);
    const double density = body.material.density().value_or(0.0);
    for (int t = 0; t < steps; ++t) {
      elasticity::AffineField b;
      for (std::size_t i = 0; bodyForce && isUniform && i < 3; ++i) b.constant[i] = (*bodyForce)[i](t, {});
      for (const VolumeLoad* load : loads) b.add(density, load->acceleration(t));
      integrals.addTo(forces[t], b);
    }
  }
  const base::Matrix temperature = temperatures_.of(body.piece);
  if (temperature.numRows() == 0) return forces;
  elasticity::ElasticPart warm(body);
  warm.temperature = &temperature;
  const base::Matrix expansion = elasticity::thermalForces(warm);
  if (forces.numRows() == 0) return expansion;
  forces += expansion;
  return forces;
}

}  // namespace harmos::scene
