#pragma once

#include <string>

#include <harmos/input/Parameters.hpp>

namespace harmos::input {

/// The whole input as XML with all defaults filled in and named values replaced by their numbers. Reading it again
/// gives the same Parameters, but for where they stand. Histories keep their names.
std::string effectiveInput(const Parameters& parameters);

}  // namespace harmos::input
