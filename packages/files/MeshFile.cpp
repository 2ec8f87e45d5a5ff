#include <harmos/files/MeshFile.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <harmos/base/Error.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/ExodusMesh.hpp>
#include <harmos/files/PythonPackage.hpp>

namespace harmos::files {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 6> convertedEndings = {".msh", ".inp", ".unv", ".med", ".vtu", ".vtk"};

bool isConverted(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::find(convertedEndings.begin(), convertedEndings.end(), ending) != convertedEndings.end();
}

/// A new folder among the temporary files.
std::string temporaryFolder() {
  std::string name = (fs::temp_directory_path() / "harmos.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw base::Error("Cannot make the folder " + name + ": " + std::strerror(errno) + ".");
  return name;
}

}  // namespace

mesh::Mesh readMesh(const std::string& path, const std::vector<std::string>& unused,
                    std::vector<std::string>* warnings) {
  if (!isConverted(path)) return readExodus(path, unused);
  const Unfinished folder(temporaryFolder());
  const std::string exodus = (fs::path(folder.path()) / "mesh.e").string();
  const ScriptEnd end = runPythonPackage({"convert", path, exodus}, {}, true);
  if (end.exitCode != 0) {
    const bool isInput = end.exitCode == static_cast<int>(base::ExitCode::input);
    std::string reason = end.errorOutput;
    reason.erase(reason.find_last_not_of('\n') + 1);
    throw base::Error("Cannot read the mesh file \"" + path + "\":\n  " + reason,
                      isInput ? base::ExitCode::input : base::ExitCode::failure);
  }
  std::istringstream lines(end.errorOutput);
  for (std::string line; warnings != nullptr && std::getline(lines, line);)
    warnings->push_back("Mesh file \"" + path + "\": " + line + ".");
  mesh::Mesh mesh = readExodus(exodus, unused);
  mesh.numbering.file = fs::path(path).filename().string();
  return mesh;
}

}  // namespace harmos::files
