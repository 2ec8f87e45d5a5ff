#pragma once

#include <harmos/input/ParameterSpec.hpp>

namespace harmos::study {

/// The whole input of a parametric study.
input::ParameterSpec studySpec();

}  // namespace harmos::study
