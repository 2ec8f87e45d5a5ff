#pragma once

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/laws/LawRegistry.hpp>

namespace harmos::scene {

/// The whole input of a scene: what every package declares, put together; of every law in `laws`, which is not kept.
input::ParameterSpec sceneSpec(const laws::LawRegistry& laws);

}  // namespace harmos::scene
