#include <harmos/scene/detail/Names.hpp>

#include <algorithm>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/scene/FaceNames.hpp>

namespace harmos::scene {

namespace {

constexpr std::size_t longestName = 64;  // Exodus readers cut names; 256 is the most that netCDF has

bool isControl(char character) {
  return static_cast<unsigned char>(character) < 0x20 || character == 0x7f;
}

}  // namespace

void checkName(const input::Parameters& list, const std::string& kind, input::ErrorList& errors) {
  const std::string& name = list.name();
  const auto refuse = [&](const std::string& what, const std::string& repair) {
    errors.add(list.where(), "the " + kind + " " + what, repair);
  };
  const auto bad = std::find_if(name.begin(), name.end(), [](char c) { return c == '/' || c == '=' || isControl(c); });
  if (bad != name.end()) {
    refuse(isControl(*bad) ? "has a line break or another control character in its name."
                           : "has " + base::quoted(std::string(1, *bad)) + " in its name.",
           "Take another name: it stands in paths, tables and files of results.");
  } else if (name == "." || name == ".." || name != base::trimmed(name)) {
    refuse("begins or ends with a blank, or is a dot.", "Take another name.");
  } else if (nameOfList(name) != name) {
    refuse("ends with" + nameOfOtherFace("") + ", as the second face of an interface does.", "Take another name.");
  } else if (name.size() > longestName) {
    refuse("has a name of " + std::to_string(name.size()) + " characters.",
           "Allowed: " + std::to_string(longestName) + ".");
  }
}

}  // namespace harmos::scene
