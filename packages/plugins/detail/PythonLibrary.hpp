#pragma once

#include <string>

namespace harmos::plugins {

/// The library that runs laws in Python: what the environment variable HARMOS_PYTHON_LAWS names, else python_laws.so in
/// the folder harmos of the libraries beside the program. Throws base::Error (input) that says what is to be installed
/// when there is none.
std::string pythonLibrary();

}  // namespace harmos::plugins
