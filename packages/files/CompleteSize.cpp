#include <harmos/files/detail/CompleteSize.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace harmos::files {
namespace {

std::uint64_t bigEndian(std::istream& file, int bytes) {
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) value = 256 * value + static_cast<unsigned char>(file.get());
  return value;
}

std::uint64_t littleEndian(std::istream& file, std::istream::off_type at, int bytes) {
  std::uint64_t value = 0;
  for (int i = bytes - 1; i >= 0; --i) {
    file.seekg(at + i);
    value = 256 * value + static_cast<unsigned char>(file.get());
  }
  return value;
}

constexpr double largestSize = 9e15;  // [byte]: up to here a double is exact

/// Reads the header of a classic netCDF file from after its first three bytes.
class ClassicHeader {
 public:
  explicit ClassicHeader(std::istream& file) : file_(file), version_(static_cast<int>(bigEndian(file, 1))) {}

  std::uint64_t end() {
    count();  // of time steps
    std::vector<std::uint64_t> dimensions;
    for (std::uint64_t left = listLength(); left > 0 && file_; --left) {
      skipName();
      dimensions.push_back(count());
    }
    skipAttributes();
    double end = 0.0;
    for (std::uint64_t left = listLength(); left > 0 && file_; --left) {
      skipName();
      double values = 1.0;  // does not overflow
      for (std::uint64_t rank = count(); rank > 0 && file_; --rank) {
        const std::uint64_t dimension = count();
        // Time, of length 0 here, gives no bytes.
        values *= dimension < dimensions.size() ? static_cast<double>(dimensions[dimension]) : 0.0;
      }
      skipAttributes();
      const double bytes = values * static_cast<double>(typeSize(bigEndian(file_, 4)));
      count();  // the same size, wrong where it does not fit
      const std::uint64_t begin = bigEndian(file_, version_ == 1 ? 4 : 8);
      if (bytes > 0.0) end = std::max(end, static_cast<double>(begin) + bytes);
    }
    return end < largestSize ? static_cast<std::uint64_t>(end) : std::numeric_limits<std::uint64_t>::max();
  }

 private:
  std::uint64_t count() { return bigEndian(file_, version_ == 5 ? 8 : 4); }
  std::uint64_t listLength() {
    bigEndian(file_, 4);  // the kind of list
    return count();
  }
  void skip(std::uint64_t bytes) { file_.ignore(static_cast<std::streamsize>((bytes + 3) / 4 * 4)); }
  void skipName() { skip(count()); }
  void skipAttributes() {
    for (std::uint64_t left = listLength(); left > 0 && file_; --left) {
      skipName();
      const std::uint64_t size = typeSize(bigEndian(file_, 4));
      skip(size * count());
    }
  }
  static std::uint64_t typeSize(std::uint64_t type) {
    constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < std::size(sizes) ? sizes[type] : 0;
  }

  std::istream& file_;
  int version_;
};

}  // namespace

std::uint64_t completeSize(std::istream& file) {
  std::string start(8, '\0');
  file.seekg(0).read(start.data(), 8);
  std::uint64_t size = 0;
  if (start.substr(0, 3) == "CDF") {
    file.clear();
    file.seekg(3);
    size = ClassicHeader(file).end();
  } else if (start == "\x89HDF\r\n\x1a\n") {
    const std::uint64_t version = littleEndian(file, 8, 1);
    size = littleEndian(file, version == 0 ? 40 : version == 1 ? 44 : 28, 8);
  }
  return file ? size : std::numeric_limits<std::uint64_t>::max();
}

}  // namespace harmos::files
