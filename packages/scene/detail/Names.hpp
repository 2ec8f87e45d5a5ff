#pragma once

#include <string>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// Reports the name of a `list`, a `kind` of thing that the results name, to `errors` unless tables, HDF5, Exodus and
/// --set can hold it.
void checkName(const input::Parameters& list, const std::string& kind, input::ErrorList& errors);

}  // namespace harmos::scene
