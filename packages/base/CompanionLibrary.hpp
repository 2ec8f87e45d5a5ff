#pragma once

#include <string>

namespace harmos::base {

/// Path of a library that the program loads only where a scene asks for it: what the environment variable `variable`
/// names, else `file` in the folder harmos of the libraries beside the program. Whether it exists is not checked.
std::string companionLibrary(const std::string& file, const char* variable);

}  // namespace harmos::base
