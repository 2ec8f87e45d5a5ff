#include <harmos/plugins/LoadPlugin.hpp>

#include <exception>
#include <filesystem>
#include <system_error>

#include <dlfcn.h>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/plugins/PluginDescription.hpp>
#include <harmos/plugins/detail/LibraryFile.hpp>
#include <harmos/plugins/detail/PythonLibrary.hpp>

namespace harmos::plugins {

namespace {

namespace fs = std::filesystem;

constexpr const char* rebuild =
    "Build the plugin anew against this Harmos: find_package(Harmos) and harmos_add_law_plugin().";

/// Why a plugin cannot be used.
class Refusal : public base::Error {
 public:
  using base::Error::Error;
};

[[noreturn]] void refuse(const std::string& path, const std::string& what, const std::string& repair) {
  throw Refusal(base::quoted(path) + " " + what + "\n  " + repair, base::ExitCode::input);
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

void* libraryOf(const std::string& path) {
  void* const library = opened(path);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    std::error_code none;
    if (!fs::exists(path, none)) {
      refuse(path, "does not exist.", "Build the plugin, or correct the path; it starts at the folder of the scene.");
    }
    refuse(path, "cannot be loaded: " + std::string(reason != nullptr ? reason : "unknown reason") + ".",
           "A plugin is a shared library that harmos_add_law_plugin() builds, or a file of Python laws, NAME.py.");
  }
  return library;
}

const PluginDescription& describedBy(const std::string& path, void* library) {
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

/// Adds the laws of a file of Python, through the library that runs Python.
void addPythonLaws(const std::string& file, laws::LawRegistry& registry) {
  const std::string path = pythonLibrary();
  void* const library = libraryOf(path);
  demandSameInterface(path, describedBy(path, library));
  using AddLaws = void (*)(const std::string&, laws::LawRegistry&);
  const auto addLaws = reinterpret_cast<AddLaws>(::dlsym(library, pythonLawsSymbol));
  if (addLaws == nullptr) refuse(path, "is not the library of Harmos that runs laws in Python.", rebuild);
  addLaws(loadable(file), registry);
}

void addLaws(const std::string& path, laws::LawRegistry& registry) {
  void* const library = libraryOf(path);
  const PluginDescription& plugin = describedBy(path, library);
  demandSameInterface(path, plugin);
  plugin.addLaws(registry);
}

/// Refuses what is no file, which Python would wait for, or read as something else.
bool isPython(const std::string& path) {
  if (fs::path(path).extension() != ".py") return false;
  std::error_code none;
  if (!fs::exists(path, none)) {
    refuse(path, "does not exist.", "Write the file, or correct the path; it starts at the folder of the scene.");
  }
  if (isPipeOrFolder(path)) refuse(path, "cannot be loaded: it is no file.", "Name a file of Python laws.");
  return true;
}

}  // namespace

void loadPlugin(const std::string& path, laws::LawRegistry& registry) {
  laws::LawRegistry extended = registry;
  const bool isInPython = isPython(path);
  const char* const unique = "Names of laws are unique among those of Harmos and of all plugins of a scene.";
  try {
    isInPython ? addPythonLaws(path, extended) : addLaws(path, extended);
  } catch (const Refusal&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, "cannot register its laws: " + std::string(error.what()),
           isInPython ? "docs/guide/python.md says what a file of laws holds. " + std::string(unique) : unique);
  } catch (...) {
    refuse(path, "cannot register its laws: it throws what is no std::exception.", "Mend the plugin.");
  }
  registry = std::move(extended);
}

}  // namespace harmos::plugins
