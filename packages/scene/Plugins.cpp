#include <harmos/scene/Plugins.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/Check.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/plugins/LoadPlugin.hpp>

namespace harmos::scene {

namespace {

constexpr const char* entry = "Plugins";

bool changesPlugins(const std::string& assignment) {
  const std::string name = assignment.substr(0, assignment.find('='));
  const auto first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
  return first != std::string::npos && name.substr(first, last - first + 1) == entry;
}

/// The scene without everything else, which need not be right; nothing when its plugins are not.
std::optional<input::Parameters> pluginsAlone(const input::InputTree& scene,
                                              const std::vector<std::string>& overrides) {
  input::InputTree reduced;
  const input::InputNode& root = scene.root;
  reduced.root = {root.tag, root.attributes, root.location, {}, "", ""};
  std::copy_if(root.children.begin(), root.children.end(), std::back_inserter(reduced.root.children),
               [](const input::InputNode& child) { return child.name() == entry; });
  std::vector<std::string> changes;
  std::copy_if(overrides.begin(), overrides.end(), std::back_inserter(changes), changesPlugins);
  if (reduced.root.children.empty() && changes.empty()) return std::nullopt;
  input::ParameterSpec spec("Harmos");
  describePlugins(spec);
  try {
    return input::check(reduced, spec, changes);
  } catch (const input::InputErrors&) {
    return std::nullopt;
  }
}

}  // namespace

void describePlugins(input::ParameterSpec& scene) {
  scene.texts(entry).optional().doc(
      "Shared libraries of interface laws that were built against this Harmos, or files NAME.py of laws in Python, "
      "paths "
      "relative to the scene. They are programs: use those that you trust.");
}

std::vector<std::string> pluginFiles(const input::Parameters& scene, const std::string& path) {
  std::vector<std::string> files;
  if (!scene.has(entry)) return files;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (const std::string& file : scene.texts(entry)) files.push_back((folder / file).lexically_normal().string());
  return files;
}

laws::LawRegistry lawsOf(const input::InputTree& scene, const std::string& path,
                         const std::vector<std::string>& overrides, const laws::LawRegistry& laws) {
  laws::LawRegistry all = laws;
  const std::optional<input::Parameters> named = pluginsAlone(scene, overrides);
  if (!named) return all;
  input::ErrorList errors;
  const std::string where = named->where(entry);
  std::vector<std::string> loaded;
  for (const std::string& file : pluginFiles(*named, path)) {
    if (std::find(loaded.begin(), loaded.end(), file) != loaded.end()) {
      errors.add(where, base::quoted(file) + " is named twice.", "Remove one of them.");
      continue;
    }
    loaded.push_back(file);
    errors.collect(where, [&] { plugins::loadPlugin(file, all); });
  }
  errors.throwIfAny();
  return all;
}

}  // namespace harmos::scene
