#include <harmos/study/Effect.hpp>

#include <algorithm>

#include <harmos/laws/FieldFollower.hpp>

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

/// Body forces, loads on masses, temperatures.
bool anyPartHasLoads(const scene::Scene& scene) {
  if (!scene.input.lists("Loads").empty() || !scene.input.lists("Temperatures").empty()) return true;
  const auto& parts = scene.input.lists("Parts");
  return std::any_of(parts.begin(), parts.end(), [](const auto& part) { return part.hasList("Body Force"); });
}

/// The effects of another draw of a random field: the laws that follow it are others.
std::vector<Effect> effectsOfField(const std::string& field, const std::string& entry, const scene::Scene& scene) {
  std::vector<Effect> effects;
  for (const char* kind : {"Interfaces", "Boundaries"}) {
    for (const input::Parameters& interface : scene.input.lists(kind)) {
      const input::Parameters& law = interface.list("Law");
      const std::vector<laws::FieldName> followed = laws::fieldNames(law);
      if (std::none_of(followed.begin(), followed.end(), [&](const auto& each) { return each.name == field; }))
        continue;
      Effect effect = effectOf(std::string(kind) + "/" + interface.name() + "/Law/", scene);
      effect.entry = entry;
      effects.push_back(std::move(effect));
    }
  }
  return effects;
}

/// Whether a path leads to an entry of Values.
bool isValue(const std::vector<std::string>& names) {
  return names.size() == 2 && names[0] == "Values";
}

}  // namespace

const char* effectName(Effect::Kind kind) {
  switch (kind) {
    case Effect::Kind::nothing:
      return "nothing";
    case Effect::Kind::localStage:
      return "local stage";
    case Effect::Kind::loads:
      return "loads";
    case Effect::Kind::operators:
      return "operators";
  }
  return "";
}

Effect effectOf(const std::string& entry, const scene::Scene& scene) {
  using Kind = Effect::Kind;
  using Target = Effect::Target;
  const std::vector<std::string> names = split(entry);
  const std::string& list = names.front();
  const std::string name = names.size() > 2 ? names[1] : "";
  const bool hasLaw = list == "Interfaces" || list == "Boundaries";
  if (hasLaw && names.size() >= 4 && names[2] == "Law") {
    const auto law = scene.laws.find(name);
    const bool isLoad = law != scene.laws.end() && law->second->prescribesTraction();
    return {isLoad ? Kind::loads : Kind::localStage, Target::law, name, entry};
  }
  // A history may belong to laws, to tractions and to loads on volumes; the last are part of the bodies.
  if (list == "Histories") {
    return {anyPartHasLoads(scene) ? Kind::operators : Kind::loads, Target::history, name, entry};
  }
  if (list == "Parts") return {Kind::operators, Target::part, name, entry};
  if (list == "Materials") return {Kind::operators, Target::material, name, entry};
  if (list == "Steps") return {Kind::operators, Target::step, name, entry};
  return {Kind::operators, Target::other, "", entry};
}

std::vector<std::string> entriesThatName(const std::string& entry, const input::References& references) {
  const std::vector<std::string> names = split(entry);
  return isValue(names) ? references.to("$" + names[1]) : std::vector<std::string>{};
}

std::vector<Effect> effectsOf(const std::string& entry, const input::References& references,
                              const scene::Scene& scene) {
  const std::vector<std::string> entries =
      isValue(split(entry)) ? entriesThatName(entry, references) : std::vector{entry};
  std::vector<Effect> effects;
  for (const std::string& each : entries) {
    const std::vector<std::string> field = split(each);
    const bool isDraw = field.size() == 4 && field[0] == "Fields" && field[2] == "Coefficients";
    const std::vector<Effect> ofLaws = isDraw ? effectsOfField(field[1], each, scene) : std::vector<Effect>{};
    if (ofLaws.empty()) effects.push_back(effectOf(each, scene));
    effects.insert(effects.end(), ofLaws.begin(), ofLaws.end());
  }
  return effects;
}

}  // namespace harmos::study
