#pragma once

#include <string>
#include <vector>

namespace harmos::files {

/// Throws base::Error (input) that names all of `outputs`, files that a command is about to write, which are among
/// `inputs`, those that it reads: by whatever path, symbolic or hard link. Files that do not exist are passed over.
void demandDistinct(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

/// Throws base::Error (input) that names all of `outputs`, files that a command is about to write, that cannot be
/// written where they are named: below what is no folder, where nobody may write, in place of a folder or a device,
/// under names that are too long. Writes nothing, and makes no folder.
void demandWritable(const std::vector<std::string>& outputs);

/// The same for a folder that is to hold files; it may exist.
void demandFolder(const std::string& output);

}  // namespace harmos::files
