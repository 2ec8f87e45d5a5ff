#include <harmos/plugins/detail/PythonLibrary.hpp>

#include <filesystem>
#include <system_error>

#include <harmos/base/CompanionLibrary.hpp>
#include <harmos/base/Error.hpp>

namespace harmos::plugins {

std::string pythonLibrary() {
  std::string library = base::companionLibrary("python_laws.so", "HARMOS_PYTHON_LAWS");
  std::error_code none;
  if (!std::filesystem::exists(library, none)) {
    throw base::Error("laws in Python are run by " + library +
                          ", which does not exist: Harmos was built without pybind11-dev and python3-dev, or a program "
                          "that is installed elsewhere has not named it in HARMOS_PYTHON_LAWS.",
                      base::ExitCode::input);
  }
  return library;
}

}  // namespace harmos::plugins
