#pragma once

#include <functional>
#include <string>
#include <vector>

namespace harmos::files {

/// How a script of the Python package ended.
struct ScriptEnd {
  int exitCode = 0;         // of the script; 130: it was interrupted
  std::string errorOutput;  // what it printed there, when that was asked for
};

/// Runs the Python package that lies beside the program, in ../share/harmos/python as built and as installed, by
/// Debian's interpreter, which has the libraries that it needs; `words` follow it, the first names the verb.
///
/// `interrupted`, asked every few milliseconds, ends the script; may be empty. With `keepsErrors` what the script
/// prints as errors is returned and not shown, and other output is dropped; otherwise both go where those of this
/// process go. Throws base::Error when the package is not there, Python cannot be started, or a signal ended it. Not
/// collective.
ScriptEnd runPythonPackage(std::vector<std::string> words, const std::function<bool()>& interrupted, bool keepsErrors);

}  // namespace harmos::files
