#pragma once

#include <string>

namespace harmos::scene {

/// Name of the second face of an interface whose law acts between two faces that are apart.
std::string nameOfOtherFace(const std::string& interface);

/// Name of the list in the scene that a face belongs to: without what nameOfOtherFace() has added.
std::string nameOfList(const std::string& face);

}  // namespace harmos::scene
