#pragma once

#include <memory>

#include <harmos/base/Parameters.hpp>
#include <harmos/study/Design.hpp>

namespace harmos::setup {

/// The design that the input of a study asks for, except the type List, whose points are read from a file.
std::unique_ptr<study::Design> makeDesign(const base::Parameters& study);

}  // namespace harmos::setup
