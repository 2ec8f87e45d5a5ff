#pragma once

#include <string>

#include <harmos/laws/LawRegistry.hpp>

namespace harmos::plugins {

/// Loads a shared library of laws, or a file NAME.py of laws in Python, and adds them to `registry`; when it throws,
/// `registry` is as it was.
///
/// Python is started in the process for the first NAME.py, by a library that lies in ../lib/harmos of the program, or
/// is named by the environment variable HARMOS_PYTHON_LAWS; it is another error where that is missing.
/// A plugin carries its own copy of the Harmos code that it uses, none of which has a state; laws and registry pass by
/// reference. It stays loaded until the process ends, so that laws may outlive the registry; the same path is the same
/// plugin from then on, whatever becomes of the file. Code that runs while a library is loaded runs unchecked: name
/// plugins only that you trust. Throws base::Error (input) that begins with the path when there is no such file, when
/// it is no shared library or no plugin, when it was built against another Harmos or by an incompatible compiler, when
/// the name of a law is taken, and when it throws while it registers its laws. Not collective: every rank that needs
/// the laws loads it.
void loadPlugin(const std::string& path, laws::LawRegistry& registry);

}  // namespace harmos::plugins
