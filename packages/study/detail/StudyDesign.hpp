#pragma once

#include <memory>

#include <harmos/design/Design.hpp>
#include <harmos/design/Refinement.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::study {

/// The design that the input of a study asks for, except the type List, whose points are read from a file.
std::unique_ptr<design::Design> makeDesign(const input::Parameters& study);

/// Of a design of the type Adaptive.
design::Refinement::Options refinementOptions(const input::Parameters& design);

}  // namespace harmos::study
