#include <harmos/files/ResultFiles.hpp>

#include <filesystem>
#include <system_error>

#include <harmos/base/Error.hpp>

namespace harmos::files {

namespace fs = std::filesystem;

ResultFiles::ResultFiles(const std::string& directory, const std::string& scene) {
  const std::string base = (fs::path(directory) / fs::path(scene).stem()).string();
  parts = base + ".e";
  interfaces = base + "_interfaces.e";
  history = base + "_history.csv";
  effectiveInput = base + "_effective.xml";
  record = base + "_result.json";
}

void ResultFiles::removeOld() const {
  std::error_code error;
  const auto directory = fs::path(parts).parent_path();
  if (!directory.empty()) fs::create_directories(directory, error);
  if (error) throw base::Error("Cannot create the directory " + directory.string() + ": " + error.message() + ".");
  for (const auto& path : all()) {
    fs::remove(path, error);
    if (error) throw base::Error("Cannot remove the old result " + path + ": " + error.message() + ".");
  }
}

}  // namespace harmos::files
