#pragma once

#include <harmos/elasticity/Material.hpp>
#include <harmos/input/Registry.hpp>

namespace harmos::elasticity {

/// The materials that a scene may name; an object, so that a host can add its own.
using MaterialRegistry = input::Registry<Material>;

/// A new registry of all materials that come with Harmos: Isotropic and Orthotropic.
MaterialRegistry builtInMaterials();

}  // namespace harmos::elasticity
