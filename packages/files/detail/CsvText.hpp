#pragma once

#include <string>

namespace harmos::files {

/// A name as a field of a CSV file: in quotes where it needs them, as RFC 4180 wants it.
std::string quoted(const std::string& name);

}  // namespace harmos::files
