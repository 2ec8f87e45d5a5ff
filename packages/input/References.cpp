#include <harmos/input/References.hpp>

#include <set>

#include <harmos/base/Numerals.hpp>

namespace harmos::input {
namespace {

using Entries = std::unordered_map<std::string, std::vector<std::string>>;

/// What a value refers to, each once.
std::set<std::string> referencesIn(const std::string& value) {
  std::set<std::string> references;
  if (value.find('$') == std::string::npos) return references;
  const auto items = base::parseItems(value);
  for (const std::string& item : items ? *items : std::vector<std::string>{value}) {
    if (!item.empty() && item.front() == '$') references.insert(item);
  }
  return references;
}

void collect(const InputNode& list, const std::string& path, Entries& entries) {
  for (const InputNode& child : list.children) {
    const std::string below = path.empty() ? child.name() : path + "/" + child.name();
    const std::string* value = child.attribute("value");
    if (child.isList()) {
      collect(child, below, entries);
    } else if (value) {
      for (const std::string& reference : referencesIn(*value)) entries[reference].push_back(below);
    }
  }
}

}  // namespace

References::References(const InputTree& input) {
  collect(input.root, "", entries_);
}

const std::vector<std::string>& References::to(const std::string& reference) const {
  static const std::vector<std::string> none;
  const auto found = entries_.find(reference);
  return found == entries_.end() ? none : found->second;
}

}  // namespace harmos::input
