#pragma once

#include <memory>
#include <type_traits>
#include <utility>

#include <harmos/plugins/PluginDescription.hpp>

namespace harmos::plugins {

/// Adds a struct as laws::addLaw() does, or a class derived from laws::InterfaceLaw with `lawName`, `describe` and a
/// constructor from parameters.
template <class Law>
void addOne(laws::LawRegistry& registry) {
  if constexpr (std::is_base_of_v<laws::InterfaceLaw, Law>) {
    input::ParameterSpec spec(Law::lawName);
    Law::describe(spec);
    registry.add(std::move(spec), [](const input::Parameters& p) -> std::unique_ptr<laws::InterfaceLaw> {
      return std::make_unique<Law>(p);
    });
  } else {
    laws::addLaw<Law>(registry);
  }
}

/// Adds all of these, in their order.
template <class... Laws>
void addLaws(laws::LawRegistry& registry) {
  (addOne<Laws>(registry), ...);
}

}  // namespace harmos::plugins

/// Makes a shared library a plugin: HARMOS_LAW_PLUGIN(Law, OtherLaw) once, at global scope, in one of its sources.
///
/// The laws are structs as PointwiseLaw describes, with `describe` and a constructor from parameters, or classes
/// derived from InterfaceLaw. The library is best built with the CMake function harmos_add_law_plugin(); nothing but
/// harmosLawPlugin() need be visible in it.
#define HARMOS_LAW_PLUGIN(...)                                                                                   \
  extern "C" __attribute__((visibility("default"))) const harmos::plugins::PluginDescription* harmosLawPlugin(); \
  const harmos::plugins::PluginDescription* harmosLawPlugin() {                                                  \
    static const harmos::plugins::PluginDescription description = {                                              \
        harmos::plugins::pluginMagic, HARMOS_INTERFACE_VERSION, HARMOS_INTERFACE_DIGEST, HARMOS_COMPILER_ABI,    \
        &harmos::plugins::addLaws<__VA_ARGS__>};                                                                 \
    return &description;                                                                                         \
  }
