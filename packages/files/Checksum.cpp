#include <harmos/files/detail/Checksum.hpp>

#include <cstdio>

#include <boost/crc.hpp>

namespace harmos::files {

std::string checksum(const std::string& bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", crc.checksum());
  return digits;
}

}  // namespace harmos::files
