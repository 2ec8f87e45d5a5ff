#include <harmos/input/Override.hpp>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::input {

namespace {

std::vector<std::string> namesIn(const std::string& path) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    names.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

InputNode& add(InputNode& parent, const char* tag, const std::string& name, const std::string& location) {
  InputNode& node = parent.children.emplace_back();
  node.tag = tag;
  node.location = location;
  node.setAttribute("name", name);
  return node;
}

ParameterType assign(InputNode& list, const std::string& name, ParameterType type, const EntryChange& change) {
  InputNode* node = list.child(name);
  if (!node) node = &add(list, InputNode::parameterTag, name, change.location);
  node->setAttribute("type", xmlType(type));
  node->setAttribute("value", change.value);
  node->location = change.location;
  return type;
}

std::vector<std::string> childNames(const InputNode& node) {
  std::vector<std::string> names;
  for (const InputNode& child : node.children) names.push_back(child.name());
  return names;
}

const ParameterSpec* formOf(const InputNode& node, const ParameterSpec& spec) {
  const InputNode* type = node.child("Type");
  const std::string* value = type ? type->attribute("value") : nullptr;
  return value ? spec.findForm(*value) : nullptr;
}

}  // namespace

void applyOverride(InputTree& input, const ParameterSpec& spec, const std::string& assignment, ErrorList& errors) {
  const std::string where = "--set '" + assignment + "'";
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) {
    errors.add(where, "has no value.", "Write --set 'List/Sublist/Name=value'.");
    return;
  }
  // Messages print paths with blanks around the slashes, so that users write them as well.
  std::string path;
  for (const std::string& name : namesIn(assignment.substr(0, equals)))
    path += (path.empty() ? "" : "/") + base::trimmed(name);
  if (path.empty()) {
    errors.add(where, "names no entry.", "Write --set 'List/Sublist/Name=value'.");
    return;
  }
  applyChange(input, spec, {path, base::trimmed(assignment.substr(equals + 1)), "--set"}, where, errors);
}

std::optional<ParameterType> applyChange(InputTree& input, const ParameterSpec& spec, const EntryChange& change,
                                         const std::string& where, ErrorList& errors) {
  const std::vector<std::string> path = namesIn(change.path);
  InputNode* node = &input.root;
  const ParameterSpec* at = &spec;
  std::string listName = spec.name();
  const auto noSuch = [&](const char* kind, const std::string& name, const std::vector<std::string>& known) {
    errors.add(where, listName + " has no " + kind + " \"" + name + "\".", base::suggestName(name, known, "It has"));
    return std::nullopt;
  };
  const auto isList = [&](const std::string& name) {
    errors.add(where, "\"" + name + "\" is a list.", "Name one of its entries: List/Sublist/Name=value.");
    return std::nullopt;
  };
  std::size_t i = 0;
  for (; i + 1 < path.size(); ++i) {
    const auto sublists = at->sublistsWith(formOf(*node, *at));
    const ParameterSpec::Sublist* next = nullptr;
    std::vector<std::string> known;
    for (const auto& sublist : sublists) {
      known.push_back(sublist.name);
      if (sublist.name == path[i]) next = &sublist;
    }
    if (!next) return noSuch("list", path[i], known);
    InputNode* child = node->child(path[i]);
    node = child ? child : &add(*node, InputNode::listTag, path[i], change.location);
    if (!node->isList()) return std::nullopt;  // check() says so
    listName = path[i];
    if (next->kind == ParameterSpec::ListKind::named) {
      const std::string& name = path[++i];
      child = node->child(name);
      if (!child) return noSuch("list", name, childNames(*node));
      if (!child->isList()) return std::nullopt;
      node = child;
      listName = name;
      if (i + 1 == path.size()) return isList(name);
    } else if (next->kind == ParameterSpec::ListKind::numbers) {
      const std::string& name = path[i + 1];
      if (i + 2 != path.size() || !node->child(name)) return noSuch("entry", name, childNames(*node));
      return assign(*node, name, ParameterType::number, change);
    }
    at = next->spec.get();
  }
  std::vector<std::string> known;
  for (const ParameterEntry& entry : at->entriesWith(formOf(*node, *at))) {
    if (entry.name == path.back()) return assign(*node, entry.name, entry.type, change);
    known.push_back(entry.name);
  }
  for (const ParameterSpec::Sublist& sublist : at->sublistsWith(formOf(*node, *at))) {
    if (sublist.name == path.back()) return isList(path.back());
  }
  return noSuch("parameter", path.back(), known);
}

}  // namespace harmos::input
