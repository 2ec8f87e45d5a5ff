#include <harmos/substructure/MultigridLibrary.hpp>

#include <filesystem>
#include <string>
#include <system_error>

#include <dlfcn.h>

#include <harmos/base/CompanionLibrary.hpp>
#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

std::string libraryFile() {
  return base::companionLibrary("multigrid.so", "HARMOS_MULTIGRID");
}

}  // namespace

bool hasMultigrid() {
  std::error_code none;
  return std::filesystem::exists(libraryFile(), none);
}

MakeMultigrid& multigridLibrary() {
  const std::string file = libraryFile();
  void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = library != nullptr ? ::dlsym(library, multigridSymbol) : nullptr;
  if (function == nullptr) {
    const char* const reason = ::dlerror();
    throw base::Error("parts are solved iteratively by " + file + ", which cannot be loaded (" +
                          (reason != nullptr ? reason : "unknown reason") +
                          "): Harmos was built without libtrilinos-muelu-dev, or a program that is installed elsewhere "
                          "has not named it in HARMOS_MULTIGRID.",
                      base::ExitCode::input);
  }
  return *reinterpret_cast<MakeMultigrid*>(function);
}

}  // namespace harmos::substructure
