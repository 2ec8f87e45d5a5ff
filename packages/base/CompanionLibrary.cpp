#include <harmos/base/CompanionLibrary.hpp>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace harmos::base {

std::string companionLibrary(const std::string& file, const char* variable) {
  if (const char* const named = std::getenv(variable)) return named;
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  return (program.parent_path().parent_path() / HARMOS_LIBRARY_FOLDER / file).string();
}

}  // namespace harmos::base
