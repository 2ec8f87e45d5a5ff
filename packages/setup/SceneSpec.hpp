#pragma once

#include <harmos/base/ParameterSpec.hpp>
#include <harmos/laws/LawRegistry.hpp>

namespace harmos::setup {

/// The whole input of a scene: what every package declares, put together.
base::ParameterSpec sceneSpec(const laws::LawRegistry& laws);

}  // namespace harmos::setup
