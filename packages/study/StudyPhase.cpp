#include <harmos/study/StudyPhase.hpp>

#include <algorithm>

#include <harmos/base/Numerals.hpp>

namespace harmos::study {

namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> names(1);
  for (const char c : path) {
    if (c == '/') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

bool refersTo(const input::InputNode& node, const std::string& reference) {
  const std::string* value = node.attribute("value");
  if (!value) return false;
  if (*value == reference) return true;
  const auto items = base::parseItems(*value);
  return items && std::find(items->begin(), items->end(), reference) != items->end();
}

void collect(const input::InputNode& list, const std::string& path, const std::string& reference,
             std::vector<std::string>& found) {
  for (const input::InputNode& child : list.children) {
    const std::string below = path.empty() ? child.name() : path + "/" + child.name();
    if (child.isList()) {
      collect(child, below, reference, found);
    } else if (refersTo(child, reference)) {
      found.push_back(below);
    }
  }
}

bool anyPartHasBodyForce(const scene::Scene& scene) {
  const auto& parts = scene.input.lists("Parts");
  return std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.hasList("Body Force"); });
}

}  // namespace

const char* phaseName(StudyPhase phase) {
  switch (phase) {
    case StudyPhase::nothing:
      return "nothing";
    case StudyPhase::localStage:
      return "local stage";
    case StudyPhase::loads:
      return "loads";
    case StudyPhase::operators:
      return "operators";
  }
  return "";
}

std::vector<std::string> effectsOf(const std::string& entry, const input::InputTree& scene) {
  const std::vector<std::string> names = split(entry);
  if (names.size() != 2 || names[0] != "Values") return {entry};
  std::vector<std::string> found;
  collect(scene.root, "", "$" + names[1], found);
  return found;
}

StudyPhase phaseOf(const std::string& entry, const scene::Scene& scene) {
  const std::vector<std::string> names = split(entry);
  const bool isJoint = names[0] == "Interfaces" || names[0] == "Boundaries";
  if (isJoint && names.size() == 4 && names[2] == "Law") {
    const auto law = scene.laws.find(names[1]);
    return law != scene.laws.end() && law->second->prescribesTraction() ? StudyPhase::loads : StudyPhase::localStage;
  }
  // A history may belong to laws, to tractions and to body forces; the last are part of the bodies.
  if (names[0] == "Histories") return anyPartHasBodyForce(scene) ? StudyPhase::operators : StudyPhase::loads;
  return StudyPhase::operators;
}

}  // namespace harmos::study
