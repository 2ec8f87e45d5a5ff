#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/ElementPoints.hpp>
#include <harmos/laws/SpatialField.hpp>
#include <harmos/scene/BodyForceComponent.hpp>
#include <harmos/scene/Scene.hpp>
#include <harmos/scene/Temperatures.hpp>
#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

/// Nodal forces of all that acts on the volume of bodies: body forces, loads on their mass, temperatures.
class BodyLoads {
 public:
  /// Reports loads that have no meaning in the kinematics to `errors`. The scene, the temperatures and the fields must
  /// outlive it.
  BodyLoads(const Scene& scene, elasticity::Kinematics kinematics, const Temperatures& temperatures,
            const laws::SpatialFields& fields, input::ErrorList& errors);

  /// Forces [force] of a body, dofs x load steps; 0 x 0 where nothing acts on it. `bodyForce`: of its part,
  /// global components. Throws base::Error (input) as elasticity::visitElements(), and for formulas that have no value
  /// at a place. Not collective.
  base::Matrix of(const elasticity::ElasticPart& body,
                  const std::optional<std::array<BodyForceComponent, 3>>& bodyForce) const;

 private:
  std::vector<const VolumeLoad*> loadsOn(const std::string& part) const;

  const Scene& scene_;
  const Temperatures& temperatures_;
  const laws::SpatialFields& fields_;
  std::vector<std::pair<const input::Parameters*, std::unique_ptr<VolumeLoad>>> loads_;
};

}  // namespace harmos::scene
