#include "Mutator.hpp"

#include <algorithm>
#include <array>

namespace {

// Where sizes and offsets overflow, in big and little endian alike.
constexpr std::array<std::uint64_t, 10> extremes = {
    0, 1, 0x7f, 0xff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fffffffffffffff, ~0ull, 0x0100000000000000};
// None of them makes a sound input large: that would be right, and slow.
const std::array<const char*, 18> words = {"0",    "-1",    "1e308", "1e-308", "nan",    "inf", "",   "{}", "{1, 2}",
                                           "true", "$none", "$mu",   "int",    "double", "/",   "..", "\"", "&#10;"};

}  // namespace

std::string Mutator::damaged(std::string bytes, bool isText) {
  for (std::size_t left = 1 + below(4); left > 0 && !bytes.empty(); --left) {
    if (isText && below(3) > 0) {
      damageText(bytes);
    } else {
      damageBytes(bytes);
    }
  }
  return bytes;
}

void Mutator::damageBytes(std::string& bytes) {
  const std::size_t at = below(bytes.size());
  const std::size_t length = std::min(bytes.size() - at, std::size_t{1} << below(10));
  switch (below(8)) {
    case 0:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
      break;
    case 1:
      bytes[at] = static_cast<char>(below(256));
      break;
    case 2:
    case 3: {
      const std::size_t size = std::min(bytes.size() - at, std::size_t{4} << below(2));
      const std::uint64_t value = extremes[below(extremes.size())];
      const bool isBig = below(2) > 0;
      for (std::size_t i = 0; i < size; ++i) {
        bytes[at + i] = static_cast<char>(value >> 8 * (isBig ? size - 1 - i : i));
      }
      break;
    }
    case 4:
      bytes.erase(at, length);
      break;
    case 5:
      bytes.insert(below(bytes.size()), bytes.substr(at, length));
      break;
    case 6:
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), length, '\0');
      break;
    default:
      bytes.resize(at);
  }
}

void Mutator::damageText(std::string& bytes) {
  // The text between two quotes: names, types and values of a parameter list.
  const std::size_t begin = bytes.find('"', below(bytes.size()));
  const std::size_t end = begin == std::string::npos ? begin : bytes.find('"', begin + 1);
  if (end == std::string::npos) return;
  if (below(3) == 0) {
    const std::size_t otherBegin = bytes.find('"', below(bytes.size()));
    const std::size_t otherEnd = otherBegin == std::string::npos ? otherBegin : bytes.find('"', otherBegin + 1);
    if (otherEnd == std::string::npos) return;
    bytes.replace(begin, end - begin + 1, bytes.substr(otherBegin, otherEnd - otherBegin + 1));
  } else {
    bytes.replace(begin + 1, end - begin - 1, words[below(words.size())]);
  }
}
