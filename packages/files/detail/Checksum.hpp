#pragma once

#include <string>

namespace harmos::files {

/// CRC-32 of `bytes` as eight hexadecimal digits.
std::string checksum(const std::string& bytes);

}  // namespace harmos::files
