#pragma once

#include <cstdlib>

#include <harmos/plugins/PluginDescription.hpp>

/// The entry point of a plugin with a description of these members, whose laws end the process when they are asked for.
#define FOREIGN_PLUGIN(...)                                                                                       \
  extern "C" __attribute__((visibility("default"))) const harmos::plugins::PluginDescription* harmosLawPlugin();  \
  const harmos::plugins::PluginDescription* harmosLawPlugin() {                                                   \
    using namespace harmos::plugins;                                                                              \
    static const PluginDescription description = {__VA_ARGS__, [](harmos::laws::LawRegistry&) { std::abort(); }}; \
    return &description;                                                                                          \
  }
