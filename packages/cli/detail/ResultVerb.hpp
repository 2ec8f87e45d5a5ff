#pragma once

#include <string>
#include <vector>

#include <harmos/cli/Command.hpp>

namespace harmos::cli {

/// Runs a verb of the Python package on the one operand, RESULT.e, on the first rank; returns its exit code.
///
/// The verb gets the result, what --output names, otherwise the result's name with `extension` (empty: without one),
/// and those of the other `options` that were given. Throws base::Error (input) where there is no such result.
int runOnResult(const std::string& verb, const std::string& extension, const std::vector<CommandOption>& options,
                const Arguments& arguments, const CommandEnvironment& environment);

}  // namespace harmos::cli
