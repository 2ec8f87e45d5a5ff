#include <harmos/plugins/LoadPlugin.hpp>

#include <exception>
#include <filesystem>
#include <system_error>

#include <dlfcn.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/plugins/PluginDescription.hpp>
#include <harmos/plugins/detail/LibraryFile.hpp>

namespace harmos::plugins {

namespace {

namespace fs = std::filesystem;

constexpr const char* rebuild =
    "Build the plugin anew against this Harmos: find_package(Harmos) and harmos_add_law_plugin().";

[[noreturn]] void refuse(const std::string& path, const std::string& what, const std::string& repair) {
  throw base::Error(base::quoted(path) + " " + what + "\n  " + repair, base::ExitCode::input);
}

/// The loader searches its own folders for a name without a slash.
std::string loadable(const std::string& path) {
  std::error_code none;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), none);
  return none ? path : whole.string();
}

/// Or the like: the loader would wait for a pipe even to tell whether it is known.
bool isPipeOrFolder(const std::string& file) {
  std::error_code none;
  return fs::exists(file, none) && !fs::is_regular_file(file, none);
}

void* opened(const std::string& path) {
  const std::string file = loadable(path);
  const auto demand = [&path](const std::string& defect) {
    if (!defect.empty()) refuse(path, "cannot be loaded: it " + defect + ".", "Build or copy the plugin anew.");
  };
  demand(isPipeOrFolder(file) ? "is no file" : "");
  if (void* const known = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD)) return known;
  demand(defectOfLibrary(file));
  return ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
}

const PluginDescription& describedBy(const std::string& path) {
  void* library = opened(path);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    std::error_code none;
    if (!fs::exists(path, none)) {
      refuse(path, "does not exist.", "Build the plugin, or correct the path; it starts at the folder of the scene.");
    }
    refuse(path, "cannot be loaded: " + std::string(reason != nullptr ? reason : "unknown reason") + ".",
           "A plugin is a shared library that harmos_add_law_plugin() builds.");
  }
  using Describe = const PluginDescription* (*)();
  const auto describe = reinterpret_cast<Describe>(::dlsym(library, pluginSymbol));
  if (describe == nullptr) {
    refuse(path, "is a shared library, but no Harmos plugin.",
           "One of its sources must have HARMOS_LAW_PLUGIN(...) with the names of its laws.");
  }
  const PluginDescription* const description = describe();
  if (description == nullptr || description->magic != pluginMagic || description->version == nullptr ||
      description->digest == nullptr || description->abi == nullptr || description->addLaws == nullptr) {
    refuse(path, "describes itself in another way than plugins of this Harmos do.", rebuild);
  }
  return *description;
}

/// Nothing else of the plugin is used before.
void demandSameInterface(const std::string& path, const PluginDescription& plugin) {
  const std::string version = plugin.version, digest = plugin.digest, abi = plugin.abi;
  if (version != HARMOS_INTERFACE_VERSION) {
    refuse(path, "was built against Harmos " + version + ", but this is " HARMOS_INTERFACE_VERSION ".", rebuild);
  }
  if (abi != HARMOS_COMPILER_ABI) {
    refuse(path,
           "was built by a compiler whose binary interface is \"" + abi +
               "\", but that of Harmos is \"" HARMOS_COMPILER_ABI "\".",
           "Build the plugin with the compiler that has built Harmos.");
  }
  if (digest != HARMOS_INTERFACE_DIGEST) {
    refuse(path,
           "was built against other headers of Harmos " + version + " (" + digest +
               ") than this program (" HARMOS_INTERFACE_DIGEST ").",
           rebuild);
  }
}

}  // namespace

void loadPlugin(const std::string& path, laws::LawRegistry& registry) {
  const PluginDescription& plugin = describedBy(path);
  demandSameInterface(path, plugin);
  laws::LawRegistry extended = registry;
  try {
    plugin.addLaws(extended);
  } catch (const std::exception& error) {
    refuse(path, "cannot register its laws: " + std::string(error.what()),
           "Names of laws are unique among those of Harmos and of all plugins of a scene.");
  } catch (...) {
    refuse(path, "cannot register its laws: it throws what is no std::exception.", "Mend the plugin.");
  }
  registry = std::move(extended);
}

}  // namespace harmos::plugins
