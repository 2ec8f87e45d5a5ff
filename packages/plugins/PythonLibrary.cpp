#include <harmos/plugins/detail/PythonLibrary.hpp>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <harmos/base/Error.hpp>

namespace harmos::plugins {

std::string pythonLibrary() {
  namespace fs = std::filesystem;
  const char* const named = std::getenv("HARMOS_PYTHON_LAWS");
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path library = named != nullptr
                               ? fs::path(named)
                               : program.parent_path().parent_path() / HARMOS_LIBRARY_FOLDER / "python_laws.so";
  if (!fs::exists(library, none)) {
    throw base::Error("laws in Python are run by " + library.string() +
                          ", which does not exist: Harmos was built without pybind11-dev and python3-dev, or a program "
                          "that is installed elsewhere has not named it in HARMOS_PYTHON_LAWS.",
                      base::ExitCode::input);
  }
  return library.string();
}

}  // namespace harmos::plugins
