#include <harmos/input/Check.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/ErrorList.hpp>
#include <harmos/input/Override.hpp>
#include <harmos/input/detail/ValueReader.hpp>

namespace harmos::input {

namespace {

using Names = std::vector<std::string>;

bool declares(const ParameterSpec& spec, const std::string& parameter) {
  const auto isIn = [&](const ParameterSpec& holder) {
    const auto& entries = holder.entries();
    return std::any_of(entries.begin(), entries.end(), [&](const auto& entry) { return entry->name == parameter; });
  };
  return isIn(spec) || std::any_of(spec.forms().begin(), spec.forms().end(), isIn);
}

/// Where a list or parameter of this name is declared below `spec`; empty when nowhere.
std::string findBelow(const ParameterSpec& spec, const std::string& name, bool isList) {
  std::vector<ParameterSpec::Sublist> sublists = spec.sublists();
  for (const ParameterSpec& form : spec.forms()) {
    sublists.insert(sublists.end(), form.sublists().begin(), form.sublists().end());
  }
  for (const auto& sublist : sublists) {
    if (isList && sublist.name == name) return name;
    const std::string path = sublist.name + (sublist.kind == ParameterSpec::ListKind::named ? " / <name>" : "") + " / ";
    if (!isList && declares(*sublist.spec, name)) return path + name;
    const std::string below = findBelow(*sublist.spec, name, isList);
    if (!below.empty()) return path + below;
  }
  return "";
}

/// Walks the tree and the declaration side by side; errors are collected in the order of the file.
class Checker {
 public:
  Checker(const InputNode& root, const ParameterSpec& spec, ErrorList& errors)
      : root_(&root), spec_(spec), errors_(errors), values_(root, errors) {}

  Parameters root() {
    wellFormed(*root_, spec_.name());
    return list(*root_, spec_, spec_.name(), spec_.name());
  }

 private:
  Parameters list(const InputNode& node, const ParameterSpec& spec, const std::string& name, const std::string& path);
  using Given = std::map<std::string, const InputNode*>;

  /// Attributes and text that do not belong; whether the node has what it needs to be read further.
  bool wellFormed(const InputNode& node, const std::string& path);
  /// The list's children of a legal tag, each name once.
  Given children(const InputNode& node, const std::string& path);
  /// Returns the name that was probably meant; empty when unclear.
  std::string unknown(const InputNode& child, const ParameterSpec& spec, const std::vector<ParameterEntry>& entries,
                      const std::vector<ParameterSpec::Sublist>& sublists, const std::string& path);
  void sublist(const InputNode* node, const ParameterSpec::Sublist& sublist, const std::string& path,
               Parameters& result);
  void numbers(const InputNode& node, const std::string& path, Parameters& result);

  std::string below(const std::string& path, const std::string& name) const {
    return path == spec_.name() ? name : path + " / " + name;
  }

  const InputNode* root_;
  const ParameterSpec& spec_;
  ErrorList& errors_;
  ValueReader values_;
};

bool Checker::wellFormed(const InputNode& node, const std::string& path) {
  const std::string where = node.location + ": " + path;
  if (!node.strayText.empty()) {
    errors_.add(node.strayLocation + ": " + path, "text " + base::quoted(node.strayText) + " stands between the tags.",
                "Remove it, or make it a comment <!-- -->.");
  }
  // Teuchos writes these besides.
  Names known = {"name", "id", "docString", "isDefault", "isUsed", "validatorId"};
  if (node.isParameter()) known.insert(known.begin() + 1, {"type", "value"});
  for (const auto& attribute : node.attributes) {
    if (std::find(known.begin(), known.end(), attribute.first) != known.end()) continue;
    errors_.add(where, "unknown attribute " + base::quoted(attribute.first) + " of <" + node.tag + ">.",
                base::suggestName(attribute.first, known, "Allowed"));
  }
  bool complete = true;
  for (const char* needed : {"name", "type", "value"}) {
    if (std::find(known.begin(), known.end(), needed) == known.end()) continue;
    const std::string* given = node.attribute(needed);
    if (given && !(std::string(needed) == "name" && given->empty())) continue;
    if (!given && &node == root_) continue;  // a Teuchos::ParameterList of a host need not be named
    errors_.add(where, "<" + node.tag + "> has no " + needed + ".",
                node.isParameter() ? "Write <Parameter name=\"...\" type=\"...\" value=\"...\"/>."
                                   : "Write <ParameterList name=\"...\">.");
    complete = false;
  }
  if (node.isParameter() && !node.children.empty()) {
    errors_.add(where, "a <Parameter> holds nothing, but <" + node.children.front().tag + "> stands in it.",
                "Close it with \"/>\", or make it a <ParameterList>.");
  }
  return complete;
}

Checker::Given Checker::children(const InputNode& node, const std::string& path) {
  Given given;
  for (const InputNode& child : node.children) {
    if (!child.isList() && !child.isParameter()) {
      errors_.add(child.location + ": " + path, "unknown element <" + child.tag + ">.",
                  base::suggestName(child.tag, {InputNode::listTag, InputNode::parameterTag}, "Allowed"));
      continue;
    }
    const std::string childPath = child.name().empty() ? path : below(path, child.name());
    if (!wellFormed(child, childPath) && child.name().empty()) continue;
    const auto [first, isNew] = given.emplace(child.name(), &child);
    if (!isNew) {
      errors_.add(child.location + ": " + childPath, "is given twice, first at " + first->second->location + ".",
                  "Remove or rename one of them.");
    }
  }
  return given;
}

std::string Checker::unknown(const InputNode& child, const ParameterSpec& spec,
                             const std::vector<ParameterEntry>& entries,
                             const std::vector<ParameterSpec::Sublist>& sublists, const std::string& path) {
  Names known;
  if (child.isParameter()) {
    for (const ParameterEntry& entry : entries) known.push_back(entry.name);
  } else {
    for (const auto& sublist : sublists) known.push_back(sublist.name);
  }
  const std::string kind = child.isList() ? "list " : "parameter ";
  std::string elsewhere = findBelow(spec, child.name(), child.isList());
  if (!elsewhere.empty()) {
    elsewhere = below(path, elsewhere);
  } else if (child.isList()) {
    elsewhere = findBelow(spec_, child.name(), true);
    if (!elsewhere.empty()) elsewhere = spec_.name() + " / " + elsewhere;
  }
  errors_.add(child.location + ": " + path, "unknown " + kind + base::quoted(child.name()) + ".",
              elsewhere.empty() ? base::suggestName(child.name(), known, "Allowed here")
                                : "It belongs at " + elsewhere +
                                      ". Allowed here: " + (known.empty() ? "none" : base::joinNames(known)) + ".");
  return elsewhere.empty() ? base::nearestName(child.name(), known) : "";
}

Parameters Checker::list(const InputNode& node, const ParameterSpec& spec, const std::string& name,
                         const std::string& path) {
  Parameters result(name, path, node.location);
  const InputNode* type = node.child("Type");
  const std::string* typeName = type ? type->attribute("value") : nullptr;
  const ParameterSpec* form = typeName ? spec.findForm(*typeName) : nullptr;
  const bool isFormKnown = form || spec.forms().empty();
  const auto entries = spec.entriesWith(form);
  const auto sublists = spec.sublistsWith(form);

  const Given given = children(node, path);
  std::map<std::string, Parameters::Value> values;
  std::set<std::string> misspelt;  // need not be reported again as missing
  for (const InputNode& child : node.children) {
    const auto found = given.find(child.name());
    if (found == given.end() || found->second != &child) continue;
    const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.name == child.name(); });
    const auto sub =
        std::find_if(sublists.begin(), sublists.end(), [&](const auto& s) { return s.name == child.name(); });
    const std::string where = child.location + ": " + below(path, child.name());
    if (entry != entries.end()) {
      if (child.isList()) {
        errors_.add(where, "is a parameter, but a list is given.", "Write " + parameterExample(*entry) + ".");
      } else if (auto read = values_.read(child, *entry, below(path, entry->name))) {
        values.emplace(entry->name, std::move(*read));
      }
    } else if (sub != sublists.end()) {
      if (child.isParameter()) {
        errors_.add(where, "is a list, but a parameter is given.",
                    "Write <ParameterList name=" + base::quoted(child.name()) + "> ... </ParameterList>.");
      }
    } else if (isFormKnown) {
      misspelt.insert(unknown(child, spec, entries, sublists, path));
    }
  }

  for (const ParameterEntry& entry : entries) {
    const auto read = values.find(entry.name);
    if (read != values.end()) {
      result.set(entry.name, std::move(read->second), given.at(entry.name)->location);
      if (entry.varies) result.restrict(entry.name, std::make_shared<const ParameterEntry>(entry));
    } else if (given.count(entry.name) == 0 && entry.isRequired()) {
      if (misspelt.count(entry.name) > 0) continue;
      std::string expected = entry.name + (entry.unitName.empty() ? "" : " [" + entry.unitName + "]");
      if (!entry.description.empty()) expected += ": " + entry.description;
      if (!entry.choices.empty()) expected += " Allowed: " + base::joinNames(entry.choices) + ".";
      errors_.add(node.location + ": " + path, "required parameter " + base::quoted(entry.name) + " is missing.",
                  expected + "\n  Add " + parameterExample(entry) + ".");
    } else if (given.count(entry.name) == 0 && entry.defaultText) {
      InputNode standard;
      standard.setAttribute("type", xmlType(entry.type));
      standard.setAttribute("value", *entry.defaultText);
      standard.location = node.location;
      if (auto filled = values_.read(standard, entry, below(path, entry.name)))
        result.set(entry.name, std::move(*filled));
      if (entry.varies) result.restrict(entry.name, std::make_shared<const ParameterEntry>(entry));
    } else if (given.count(entry.name) == 0 && entry.varies && given.count(entry.name + " History") > 0) {
      errors_.add(given.at(entry.name + " History")->location + ": " + path,
                  base::quoted(entry.name + " History") + " is given without " + base::quoted(entry.name) + ".",
                  "Add " + parameterExample(entry) + ", which the history multiplies.");
    }
  }
  for (const auto& sub : sublists) {
    const auto found = given.find(sub.name);
    if (found == given.end() ? misspelt.count(sub.name) == 0 : found->second->isList()) {
      sublist(found == given.end() ? nullptr : found->second, sub, path, result);
    }
  }
  return result;
}

void Checker::sublist(const InputNode* node, const ParameterSpec::Sublist& sublist, const std::string& path,
                      Parameters& result) {
  const std::string childPath = below(path, sublist.name);
  if (!node) {
    if (sublist.required) {
      errors_.add(result.where(), "required list " + base::quoted(sublist.name) + " is missing.",
                  (sublist.spec->summary().empty() ? "" : sublist.spec->summary() + " ") +
                      "Add <ParameterList name=" + base::quoted(sublist.name) + "> ... </ParameterList>.");
    } else if (sublist.kind == ParameterSpec::ListKind::fixed && !sublist.optional) {
      InputNode empty;
      empty.tag = InputNode::listTag;
      empty.location = result.location();
      result.setList(sublist.name, list(empty, *sublist.spec, sublist.name, childPath));
    }
    return;
  }
  switch (sublist.kind) {
    case ParameterSpec::ListKind::fixed:
      result.setList(sublist.name, list(*node, *sublist.spec, sublist.name, childPath));
      break;
    case ParameterSpec::ListKind::numbers:
      numbers(*node, childPath, result);
      break;
    case ParameterSpec::ListKind::named: {
      const Given given = children(*node, childPath);
      for (const InputNode& child : node->children) {
        const auto found = given.find(child.name());
        if (found == given.end() || found->second != &child) continue;
        const std::string name = child.name();
        if (child.isParameter()) {
          errors_.add(
              child.location + ": " + below(childPath, name), "is a parameter, but a list is expected.",
              sublist.name + " holds lists: <ParameterList name=" + base::quoted(name) + "> ... </ParameterList>.");
        } else {
          result.addNamed(sublist.name, list(child, *sublist.spec, name, below(childPath, name)));
        }
      }
      if (given.empty() && sublist.required) {
        errors_.add(node->location + ": " + childPath, "the list is empty, but must hold at least one list.",
                    "Add <ParameterList name=\"...\"> ... </ParameterList>, with a name of your choice.");
      }
    }
  }
}

void Checker::numbers(const InputNode& node, const std::string& path, Parameters& result) {
  Parameters values(node.name(), path, node.location);
  const Given given = children(node, path);
  for (const InputNode& child : node.children) {
    const auto found = given.find(child.name());
    if (found == given.end() || found->second != &child) continue;
    const ParameterEntry entry(child.name(), ParameterType::number);
    if (child.isList()) {
      errors_.add(child.location + ": " + below(path, child.name()), "is a list, but a parameter is expected.",
                  "Write " + parameterExample(entry) + ".");
      continue;
    }
    const std::string* text = child.attribute("value");
    if (text && text->find('$') != std::string::npos) {
      errors_.add(child.location + ": " + below(path, child.name()), base::quoted(*text) + " refers to another value.",
                  "Write a number here.");
    } else if (auto read = values_.read(child, entry, below(path, entry.name))) {
      values.set(child.name(), std::move(*read), child.location);
    }
  }
  result.setList(node.name(), std::move(values));
}

}  // namespace

Parameters check(InputTree input, const ParameterSpec& spec, const std::vector<std::string>& overrides) {
  ErrorList errors;
  const InputNode& root = input.root;
  const std::string* name = root.attribute("name");
  if (!root.isList() || (name && *name != spec.name())) {
    errors.add(root.location, "the root element is <" + root.tag + (name ? " name=" + base::quoted(*name) : "") + ">.",
               "It must be <ParameterList name=" + base::quoted(spec.name()) + ">.");
    if (!root.isList()) errors.throwIfAny();
  }
  for (const std::string& assignment : overrides) applyOverride(input, spec, assignment, errors);
  Checker checker(root, spec, errors);
  Parameters result = checker.root();
  errors.throwIfAny();
  return result;
}

}  // namespace harmos::input
