#pragma once

#include <harmos/plugins/PluginDescription.hpp>

namespace harmos::plugins {

/// Adds all of these structs to a registry, see laws::addLaw().
template <class... Laws>
void addLaws(laws::LawRegistry& registry) {
  (laws::addLaw<Laws>(registry), ...);
}

}  // namespace harmos::plugins

/// Makes a shared library a plugin: HARMOS_LAW_PLUGIN(Law, OtherLaw) once, at global scope, in one of its sources.
///
/// The laws are structs as PointwiseLaw describes, with `describe` and a constructor from parameters. The library is
/// best built with the CMake function harmos_add_law_plugin(); nothing but harmosLawPlugin() need be visible in it.
#define HARMOS_LAW_PLUGIN(...)                                                                                   \
  extern "C" __attribute__((visibility("default"))) const harmos::plugins::PluginDescription* harmosLawPlugin(); \
  const harmos::plugins::PluginDescription* harmosLawPlugin() {                                                  \
    static const harmos::plugins::PluginDescription description = {                                              \
        harmos::plugins::pluginMagic, HARMOS_INTERFACE_VERSION, HARMOS_INTERFACE_DIGEST, HARMOS_COMPILER_ABI,    \
        &harmos::plugins::addLaws<__VA_ARGS__>};                                                                 \
    return &description;                                                                                         \
  }
