#pragma once

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/ElementPoints.hpp>

namespace harmos::elasticity {

/// Nodal forces by which a part expands as its temperature tells it to: int B^t C alpha T dV [force], dofs x columns of
/// ElasticPart::temperature, which must be given. They balance each other. Throws as visitElements(). Not collective.
base::Matrix thermalForces(const ElasticPart& part);

}  // namespace harmos::elasticity
