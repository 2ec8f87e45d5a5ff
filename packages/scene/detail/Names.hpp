#pragma once

#include <string>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// Reports the name of a `list`, a `kind` of thing that the results name, to `errors` unless tables, HDF5, Exodus and
/// --set can hold it.
void checkName(const input::Parameters& list, const std::string& kind, input::ErrorList& errors);

/// Name of the second face of an interface whose law acts between two faces that are apart.
std::string nameOfOtherFace(const std::string& interface);

/// Name of the list in the scene that a face belongs to: without what nameOfOtherFace() has added.
std::string nameOfList(const std::string& face);

}  // namespace harmos::scene
