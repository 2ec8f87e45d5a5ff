#pragma once

#include <string>
#include <vector>

#include <harmos/input/InputTree.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// What a scene says without effect, a sentence each, with its place: values, materials and histories that nothing
/// refers to, and histories that begin when the last load step has ended.
///
/// `written`: the scene as in its file, `overrides` what replaces entries of it ("List/Name=value"); `scene`: the same,
/// checked; `times`: ends of the load steps [time].
std::vector<std::string> unusedEntries(const input::InputTree& written, const std::vector<std::string>& overrides,
                                       const input::Parameters& scene, const std::vector<double>& times);

}  // namespace harmos::scene
