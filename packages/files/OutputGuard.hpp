#pragma once

#include <string>
#include <vector>

namespace harmos::files {

/// Throws base::Error (input) that names all of `outputs`, files that a command is about to write, which are among
/// `inputs`, those that it reads: by whatever path, symbolic or hard link. Files that do not exist are passed over.
void demandDistinct(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace harmos::files
