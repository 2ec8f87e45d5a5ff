#pragma once

#include <string>

#include <harmos/scene/Scene.hpp>

namespace harmos::scene {

/// The whole input of a scene with all defaults, as XML that is to be written to `file`: relative names of files in it
/// start at the folder of `file`, so that it runs from anywhere and moves with what it names. Absolute ones stay.
std::string effectiveScene(const Scene& scene, const std::string& file);

}  // namespace harmos::scene
