#include <harmos/scene/detail/EffectiveScene.hpp>

#include <filesystem>

#include <harmos/input/EffectiveInput.hpp>

namespace harmos::scene {

namespace {

namespace fs = std::filesystem;

/// Links resolved as far as there are files, so that ".." leads where it says.
fs::path resolved(const fs::path& path) {
  std::error_code ignored;
  const fs::path found = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  return found.empty() ? path : found;
}

/// A name that starts at the folder of `from`, as one that starts at the folder of `to`.
std::string renamed(const std::string& name, const std::string& from, const std::string& to) {
  if (fs::path(name).is_absolute()) return name;
  const fs::path file = resolved(fs::path(from).parent_path() / name);
  const fs::path relative = file.lexically_relative(resolved(to).parent_path());
  return (relative.empty() ? file : relative).string();
}

}  // namespace

std::string effectiveScene(const Scene& scene, const std::string& file) {
  input::Parameters input = scene.input;
  input::Parameters mesh = input.list("Mesh");
  if (mesh.has("File")) {
    mesh.set("File", renamed(mesh.text("File"), scene.path, file));
    input.setList("Mesh", std::move(mesh));
  }
  if (input.has("Plugins")) {
    std::vector<std::string> plugins;
    for (const std::string& plugin : input.texts("Plugins")) plugins.push_back(renamed(plugin, scene.path, file));
    input.set("Plugins", std::move(plugins));
  }
  return input::effectiveInput(input);
}

}  // namespace harmos::scene
