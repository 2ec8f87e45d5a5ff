#pragma once

#include <memory>

#include <harmos/base/Parameters.hpp>
#include <harmos/study/Design.hpp>
#include <harmos/study/Refinement.hpp>

namespace harmos::setup {

/// The design that the input of a study asks for, except the type List, whose points are read from a file.
std::unique_ptr<study::Design> makeDesign(const base::Parameters& study);

/// Of a design of the type Adaptive.
study::Refinement::Options refinementOptions(const base::Parameters& design);

}  // namespace harmos::setup
