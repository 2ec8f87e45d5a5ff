#include <harmos/plugins/detail/LibraryFile.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <elf.h>
#include <link.h>

namespace harmos::plugins {
namespace {

/// Reads a record of the format at some place.
template <class Record>
bool read(std::ifstream& file, std::uint64_t place, Record& record) {
  std::array<char, sizeof(Record)> bytes{};
  file.seekg(static_cast<std::streamoff>(place));
  if (!file.read(bytes.data(), bytes.size())) return false;
  std::memcpy(&record, bytes.data(), bytes.size());
  return true;
}

}  // namespace

std::string defectOfLibrary(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code none;
  const std::uint64_t size = fs::file_size(path, none);
  if (none) return {};
  const auto holds = [size](std::uint64_t begin, std::uint64_t length) {
    return begin <= size && length <= size - begin;
  };
  const auto cutShort = [size] { return "was cut short: it has " + std::to_string(size) + " bytes"; };
  std::ifstream file(path, std::ios::binary);
  ElfW(Ehdr) header{};
  // What is no library at all the loader tells.
  if (!read(file, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return {};
  if (header.e_phentsize != sizeof(ElfW(Phdr))) return {};
  if (!holds(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize)) return cutShort();
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    ElfW(Phdr) segment{};
    const std::uint64_t offset = i * sizeof(segment);
    if (!holds(header.e_phoff, offset + sizeof(segment)) || !read(file, header.e_phoff + offset, segment) ||
        !holds(segment.p_offset, segment.p_filesz)) {
      return cutShort();
    }
  }
  return {};
}

}  // namespace harmos::plugins
