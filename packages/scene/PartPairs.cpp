#include <harmos/scene/detail/PartPairs.hpp>

#include <algorithm>

#include <fnmatch.h>

#include <harmos/base/Error.hpp>

namespace harmos::scene {
namespace {

bool hasPattern(const input::Parameters& interface) {
  return isPattern(interface.text("Part 1")) || isPattern(interface.text("Part 2"));
}

}  // namespace

bool isPattern(const std::string& name) {
  return name.find_first_of("*?") != std::string::npos;
}

std::vector<std::string> fittingNames(const std::string& pattern, const std::vector<std::string>& names) {
  std::vector<std::string> fitting;
  for (const std::string& name : names) {
    if (name == pattern || (isPattern(pattern) && fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0)) {
      fitting.push_back(name);
    }
  }
  return fitting;
}

std::set<std::string> partsOf(const std::string& sideSet, const mesh::Mesh& mesh,
                              const std::vector<mesh::Piece>& pieces) {
  std::set<std::string> names;
  for (const mesh::SideSet& set : mesh.sideSets) {
    if (set.name != sideSet) continue;
    for (const int element : set.element) {
      for (const mesh::Piece& piece : pieces) {
        if (std::binary_search(piece.elements.begin(), piece.elements.end(), element)) names.insert(piece.part);
      }
    }
  }
  return names;
}

PartPairs::PartPairs(const input::Parameters& scene, const mesh::Mesh& mesh, const std::vector<mesh::Piece>& pieces)
    : mesh_(mesh), pieces_(pieces) {
  for (const input::Parameters& part : scene.lists("Parts")) parts_.push_back(part.name());
  const auto& interfaces = scene.lists("Interfaces");
  const auto isGivenByPattern = [](const input::Parameters& list) { return list.has("Part 1") && hasPattern(list); };
  if (std::none_of(interfaces.begin(), interfaces.end(), isGivenByPattern)) return;
  for (const input::Parameters& interface : interfaces) {
    if (interface.has("Side 1")) {
      for (const std::string& first : partsOf(interface.text("Side 1"), mesh, pieces)) {
        for (const std::string& second : partsOf(interface.text("Side 2"), mesh, pieces)) {
          taken_.insert(std::minmax(first, second));
        }
      }
    } else if (interface.has("Part 1") && !hasPattern(interface)) {
      taken_.insert(std::minmax(interface.text("Part 1"), interface.text("Part 2")));
    }
  }
}

std::vector<mesh::PartPair> PartPairs::of(const input::Parameters& interface) {
  const std::string &part1 = interface.text("Part 1"), &part2 = interface.text("Part 2");
  if (!hasPattern(interface)) return {{part1, part2}};
  std::vector<mesh::PartPair> pairs;
  for (const mesh::PartPair& pair :
       mesh::touchingParts(mesh_, pieces_, fittingNames(part1, parts_), fittingNames(part2, parts_))) {
    if (taken_.insert(std::minmax(pair.first, pair.second)).second) pairs.push_back(pair);
  }
  if (!pairs.empty()) return pairs;
  throw base::Error("no parts that \"" + part1 + "\" and \"" + part2 +
                        "\" fit have faces on each other that no other interface joins.\n  Name two parts, or two side "
                        "sets where the sides are open initially.",
                    base::ExitCode::input);
}

}  // namespace harmos::scene
