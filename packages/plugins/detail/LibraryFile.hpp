#pragma once

#include <string>

namespace harmos::plugins {

/// What a file lacks to be loaded as a shared library, in words that follow "it"; empty: nothing that is seen from
/// outside. The loader ends the process at files that were cut short, and waits for ever at a pipe: it must not be
/// asked about them. That there is no such file is left to it.
std::string defectOfLibrary(const std::string& path);

}  // namespace harmos::plugins
