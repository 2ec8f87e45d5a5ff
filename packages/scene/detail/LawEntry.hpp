#pragma once

#include <string>

#include <harmos/input/InputTree.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// The value of a number of a scene that only laws depend on: "Interfaces/NAME/Law/ENTRY",
/// "Boundaries/NAME/Law/ENTRY", either of a list in the law as well, "Fields/NAME/Coefficients/ENTRY", or "Values/NAME"
/// that only such entries name by "$NAME". `scene`: the checked values of `input`. Throws base::Error (input) for every
/// other entry.
double lawEntry(const input::InputTree& input, const input::Parameters& scene, const std::string& entry);

}  // namespace harmos::scene
