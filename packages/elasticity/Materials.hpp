#pragma once

#include <harmos/elasticity/Material.hpp>
#include <harmos/input/Registry.hpp>

namespace harmos::elasticity {

/// The materials that a scene may name; an object, so that a host can add its own.
using MaterialRegistry = input::Registry<Material>;

/// All materials that come with Harmos.
MaterialRegistry builtInMaterials();

}  // namespace harmos::elasticity
