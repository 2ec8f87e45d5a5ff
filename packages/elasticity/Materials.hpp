#pragma once

#include <harmos/base/Registry.hpp>
#include <harmos/elasticity/Material.hpp>

namespace harmos::elasticity {

/// The materials that a scene may name; an object, so that a host can add its own.
using MaterialRegistry = base::Registry<Material>;

/// All materials that come with Harmos.
MaterialRegistry builtInMaterials();

}  // namespace harmos::elasticity
