#pragma once

#include <harmos/base/ParameterSpec.hpp>

namespace harmos::setup {

/// The whole input of a parametric study.
base::ParameterSpec studySpec();

}  // namespace harmos::setup
