#include <harmos/files/ResultFiles.hpp>

#include <filesystem>

namespace harmos::files {

namespace fs = std::filesystem;

ResultFiles::ResultFiles(const std::string& directory, const std::string& scene) {
  const std::string base = (fs::path(directory) / fs::path(scene).stem()).string();
  parts = base + ".e";
  interfaces = base + "_interfaces.e";
  history = base + "_history.csv";
  effectiveInput = base + "_effective.xml";
  record = base + "_result.json";
  derivatives = base + "_derivatives.csv";
}

}  // namespace harmos::files
