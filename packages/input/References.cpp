#include <harmos/input/References.hpp>

#include <algorithm>

#include <harmos/base/Numerals.hpp>

namespace harmos::input {
namespace {

bool refersTo(const InputNode& node, const std::string& reference) {
  const std::string* value = node.attribute("value");
  if (!value) return false;
  if (*value == reference) return true;
  const auto items = base::parseItems(*value);
  return items && std::find(items->begin(), items->end(), reference) != items->end();
}

void collect(const InputNode& list, const std::string& path, const std::string& reference,
             std::vector<std::string>& found) {
  for (const InputNode& child : list.children) {
    const std::string below = path.empty() ? child.name() : path + "/" + child.name();
    if (child.isList()) {
      collect(child, below, reference, found);
    } else if (refersTo(child, reference)) {
      found.push_back(below);
    }
  }
}

}  // namespace

std::vector<std::string> entriesThatName(const InputTree& input, const std::string& reference) {
  std::vector<std::string> found;
  collect(input.root, "", reference, found);
  return found;
}

}  // namespace harmos::input
