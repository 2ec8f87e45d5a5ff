#pragma once

#include <harmos/input/ParameterSpec.hpp>

namespace harmos::study {

/// The whole input of a parametric study; that of its scene is scene::sceneSpec().
input::ParameterSpec studySpec();

}  // namespace harmos::study
