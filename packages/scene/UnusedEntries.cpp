#include <harmos/scene/detail/UnusedEntries.hpp>

#include <algorithm>
#include <set>
#include <variant>

#include <harmos/base/Numerals.hpp>

namespace harmos::scene {

namespace {

using Names = std::set<std::string>;

/// Adds the names that a value as it is written, "$name" or a list of such, refers to.
void addReferences(const std::string& value, Names& names) {
  const auto add = [&](const std::string& item) {
    if (!item.empty() && item[0] == '$') names.insert(item.substr(1));
  };
  add(value);
  if (const auto items = base::parseItems(value)) std::for_each(items->begin(), items->end(), add);
}

void addReferences(const input::InputNode& node, Names& names) {
  if (const std::string* value = node.attribute("value")) addReferences(*value, names);
  for (const input::InputNode& child : node.children) addReferences(child, names);
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Adds what entries of a list, or of those in it, name whose own names end in `kind`.
void addNamed(const std::string& kind, const input::Parameters& list, Names& names) {
  for (const auto& entry : list.entries()) {
    const auto* name = std::get_if<std::string>(&entry.value);
    if (name != nullptr && endsWith(entry.name, " " + kind)) names.insert(*name);
  }
  for (const auto& sublist : list.sublists()) {
    for (const input::Parameters& below : sublist.lists) addNamed(kind, below, names);
  }
}

/// When a history changes for the first time; the constant ones never do, but say so.
double beginOf(const input::Parameters& history) {
  if (history.type() == "Ramp") return history.number("Start");
  if (history.type() == "Formula") return 0.0;
  const auto& times = history.numbers("Times");
  return times.size() > 1 ? times.front() : 0.0;
}

}  // namespace

std::vector<std::string> unusedEntries(const input::InputTree& written, const std::vector<std::string>& overrides,
                                       const input::Parameters& scene, const std::vector<double>& times) {
  std::vector<std::string> sentences;
  Names values, materials, histories, fields;
  addReferences(written.root, values);
  for (const std::string& assignment : overrides) {
    const auto equals = assignment.find('=');
    if (equals != std::string::npos) addReferences(assignment.substr(equals + 1), values);
  }
  if (const input::InputNode* list = written.root.child("Values")) {
    for (const input::InputNode& value : list->children) {
      if (values.count(value.name()) > 0) continue;
      sentences.push_back(value.location + ": Values / " + value.name() + ": nothing refers to this value.");
    }
  }
  for (const input::Parameters& part : scene.lists("Parts")) materials.insert(part.text("Material"));
  for (const input::Parameters& material : scene.lists("Materials")) {
    if (materials.count(material.name()) == 0) sentences.push_back(material.where() + ": no part has this material.");
  }
  addNamed("History", scene, histories);
  addNamed("Field", scene, fields);
  for (const input::Parameters& field : scene.lists("Fields")) {
    if (fields.count(field.name()) == 0) sentences.push_back(field.where() + ": nothing follows this field.");
  }
  const input::Histories factors = scene.histories();
  for (const input::Parameters& history : scene.lists("Histories")) {
    const std::vector<double>* perStep = factors.find(history.name());
    if (histories.count(history.name()) == 0) {
      sentences.push_back(history.where() + ": nothing follows this history.");
    } else if (!times.empty() && beginOf(history) >= times.back()) {
      sentences.push_back(history.where() + ": it begins at time " + base::toText(beginOf(history)) +
                          ", but the last load step ends at time " + base::toText(times.back()) +
                          ", so that what follows it never changes.");
    } else if (perStep != nullptr && !perStep->empty() &&
               std::all_of(perStep->begin(), perStep->end(), [](double x) { return x == 0.0; })) {
      sentences.push_back(history.where() + ": it is 0 at every load step, so that what follows it is 0 throughout.");
    }
  }
  const input::Parameters& output = scene.list("Output");
  if (output.flag("Nodal Stress") && !output.flag("Fields")) {
    sentences.push_back(output.where("Nodal Stress") + ": no stresses are computed, because Fields is false.");
  }
  return sentences;
}

}  // namespace harmos::scene
