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

// Lists that the input omits are null in these.
std::vector<std::string> childNames(const InputNode* list) {
  std::vector<std::string> names;
  if (!list) return names;
  for (const InputNode& child : list->children) names.push_back(child.name());
  return names;
}

const InputNode* childOf(const InputNode* list, const std::string& name) {
  return list ? list->child(name) : nullptr;
}

const ParameterSpec* formOf(const InputNode* list, const ParameterSpec& spec) {
  const InputNode* type = childOf(list, "Type");
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

std::optional<ParameterType> typeOf(const InputTree& input, const ParameterSpec& spec, const std::string& entry,
                                    const std::string& where, ErrorList& errors) {
  const std::vector<std::string> path = namesIn(entry);
  const InputNode* node = &input.root;
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
    const auto sublists = at->sublistsWith(formOf(node, *at));
    const ParameterSpec::Sublist* next = nullptr;
    std::vector<std::string> known;
    for (const auto& sublist : sublists) {
      known.push_back(sublist.name);
      if (sublist.name == path[i]) next = &sublist;
    }
    if (!next) return noSuch("list", path[i], known);
    node = childOf(node, path[i]);
    if (node && !node->isList()) return std::nullopt;  // check() says so
    listName = path[i];
    if (next->kind == ParameterSpec::ListKind::named) {
      const std::string& name = path[++i];
      const InputNode* child = childOf(node, name);
      if (!child) return noSuch("list", name, childNames(node));
      if (!child->isList()) return std::nullopt;
      node = child;
      listName = name;
      if (i + 1 == path.size()) return isList(name);
    } else if (next->kind == ParameterSpec::ListKind::numbers) {
      const std::string& name = path[i + 1];
      if (i + 2 != path.size() || !childOf(node, name)) return noSuch("entry", name, childNames(node));
      return ParameterType::number;
    }
    at = next->spec.get();
  }
  std::vector<std::string> known;
  for (const ParameterEntry& declared : at->entriesWith(formOf(node, *at))) {
    if (declared.name == path.back()) return declared.type;
    known.push_back(declared.name);
  }
  for (const ParameterSpec::Sublist& sublist : at->sublistsWith(formOf(node, *at))) {
    if (sublist.name == path.back()) return isList(path.back());
  }
  return noSuch("parameter", path.back(), known);
}

bool applyChange(InputTree& input, const ParameterSpec& spec, const EntryChange& change, const std::string& where,
                 ErrorList& errors) {
  const std::optional<ParameterType> type = typeOf(input, spec, change.path, where, errors);
  if (!type) return false;
  const std::vector<std::string> path = namesIn(change.path);
  InputNode* node = &input.root;
  for (const std::string& name : path) {
    InputNode* child = node->child(name);
    const char* tag = &name == &path.back() ? InputNode::parameterTag : InputNode::listTag;
    node = child ? child : &add(*node, tag, name, change.location);
  }
  node->setAttribute("type", xmlType(*type));
  node->setAttribute("value", change.value);
  node->location = change.location;
  return true;
}

}  // namespace harmos::input
