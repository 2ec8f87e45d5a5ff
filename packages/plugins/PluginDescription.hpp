#pragma once

#include <string>

#include <harmos/laws/LawRegistry.hpp>
#include <harmos/plugins/InterfaceDigest.hpp>

#define HARMOS_PLUGIN_TEXT_OF(x) #x
#define HARMOS_PLUGIN_TEXT(x) HARMOS_PLUGIN_TEXT_OF(x)

/// What the compiler makes of the same headers: its binary interface and the layout of the standard library's strings
/// and containers.
#ifdef _GLIBCXX_DEBUG
#define HARMOS_COMPILER_ABI                                                       \
  "gnu++ " HARMOS_PLUGIN_TEXT(__GXX_ABI_VERSION) ", strings " HARMOS_PLUGIN_TEXT( \
      _GLIBCXX_USE_CXX11_ABI) ", checked containers"
#else
#define HARMOS_COMPILER_ABI \
  "gnu++ " HARMOS_PLUGIN_TEXT(__GXX_ABI_VERSION) ", strings " HARMOS_PLUGIN_TEXT(_GLIBCXX_USE_CXX11_ABI)
#endif

/// Shared libraries of laws that are built outside of Harmos.
namespace harmos::plugins {

/// What a plugin says of itself before anything of it is used. Only numbers and plain texts: it can be read whatever
/// the plugin was compiled with. The texts belong to the plugin, which is never unloaded.
struct PluginDescription {
  unsigned long magic;  ///< pluginMagic; else the symbol means something else
  const char* version;  ///< HARMOS_INTERFACE_VERSION of the headers that it was compiled with
  const char* digest;   ///< HARMOS_INTERFACE_DIGEST of these
  const char* abi;      ///< HARMOS_COMPILER_ABI of its compiler
  /// Adds its laws to the registry; throws base::Error when a name is taken.
  void (*addLaws)(laws::LawRegistry&);
};

/// First number of every description; another one where the struct itself changes.
constexpr unsigned long pluginMagic = 0x4841524D4F530001;  // "HARMOS", 1

/// Name of the function, extern "C" and without arguments, that returns a `const PluginDescription*`.
constexpr const char* pluginSymbol = "harmosLawPlugin";
/// Name of the function, extern "C", by which the library that runs laws in Python adds those of a file to a registry:
/// void(const std::string& file, laws::LawRegistry&). It throws base::Error with the cause. The library is a plugin
/// besides, without laws of its own.
constexpr const char* pythonLawsSymbol = "harmosPythonLaws";

}  // namespace harmos::plugins
