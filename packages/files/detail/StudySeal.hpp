#pragma once

#include <string>

#include <harmos/files/detail/Checksum.hpp>

namespace harmos::files {

/// What stands in the file of a study behind the bytes of HDF5, which does not look there.
inline std::string studySeal(const std::string& bytes) {
  return "harmos:" + checksum(bytes) + "\n";
}

}  // namespace harmos::files
