#pragma once

#include <string>
#include <vector>

#include <harmos/input/InputTree.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/laws/LawRegistry.hpp>

namespace harmos::scene {

/// Declares "Plugins" of a scene.
void describePlugins(input::ParameterSpec& scene);

/// The plugins that a checked scene names, as paths that start where the program does; `path` is that of the scene.
std::vector<std::string> pluginFiles(const input::Parameters& scene, const std::string& path);

/// The laws that a scene may name: those given, and those of its plugins. The scene need not be checked otherwise;
/// "Plugins" that cannot be read, which its check reports, count as none. `path` and `overrides` as of makeScene().
/// Loads the plugins, see plugins::loadPlugin(). Throws one base::Error (input) that lists all plugins that cannot be
/// used. Not collective: every rank loads them.
laws::LawRegistry lawsOf(const input::InputTree& scene, const std::string& path,
                         const std::vector<std::string>& overrides, const laws::LawRegistry& laws);

}  // namespace harmos::scene
