#include <harmos/scene/detail/BodyLoads.hpp>

#include <algorithm>

#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/ThermalLoad.hpp>

namespace harmos::scene {

namespace {

bool followsPlace(const BodyForceComponent& component) {
  const input::Field& number = component.number;
  return !component.field.empty() || number.looksAt("x") || number.looksAt("y") || number.looksAt("z");
}

}  // namespace

BodyLoads::BodyLoads(const Scene& scene, elasticity::Kinematics kinematics, const Temperatures& temperatures,
                     const laws::SpatialFields& fields, input::ErrorList& errors)
    : scene_(scene), temperatures_(temperatures), fields_(fields) {
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
                           const std::optional<std::array<BodyForceComponent, 3>>& bodyForce) const {
  const int dofs = elasticity::componentsOf(body.kinematics) * static_cast<int>(body.piece.nodes.size());
  const int steps = static_cast<int>(scene_.times.size());
  const std::vector<const VolumeLoad*> loads = loadsOn(body.piece.part);
  base::Matrix forces;
  if (bodyForce || !loads.empty()) {
    forces.shape(dofs, steps);
    const bool isUniform = !bodyForce || std::none_of(bodyForce->begin(), bodyForce->end(), followsPlace);
    if (!isUniform) {
      std::vector<int> nodes;
      elasticity::BodyForce::addTo(forces, body, [&](int step, const elasticity::ElementPoints& at, int p) {
        nodes.clear();
        for (int a = 0; a < at.nodes; ++a) nodes.push_back(body.piece.nodes[at.node[a]]);
        const laws::InnerPoint inner{body.piece.elements[at.element], at.nodes, nodes.data(), at.value + p * at.nodes};
        base::Vector3 force{};
        for (std::size_t i = 0; i < 3; ++i) {
          const auto& [number, field] = (*bodyForce)[i];
          force[i] = number(step, at.position[p]) * (field.empty() ? 1.0 : fields_.at(field)->inside(step, inner));
        }
        return force;
      });
    }
    const elasticity::BodyForce integrals(body);
    const double density = body.material.density().value_or(0.0);
    for (int t = 0; t < steps; ++t) {
      elasticity::AffineField b;
      for (std::size_t i = 0; bodyForce && isUniform && i < 3; ++i) b.constant[i] = (*bodyForce)[i].number(t, {});
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
