#include <harmos/scene/detail/LawEntry.hpp>

#include <algorithm>
#include <optional>
#include <sstream>
#include <variant>
#include <vector>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/input/References.hpp>

namespace harmos::scene {
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> names;
  std::istringstream stream(path);
  for (std::string name; std::getline(stream, name, '/');) names.push_back(name);
  return names;
}

/// Of a law, or of a field that laws follow.
bool isOfLaw(const std::vector<std::string>& names) {
  if (names.size() == 4 && names[0] == "Fields") return names[2] == "Coefficients";
  return names.size() >= 4 && (names[0] == "Interfaces" || names[0] == "Boundaries") && names[2] == "Law";
}

/// The list that holds the last of these names; null: there is none.
const input::Parameters* listOf(const input::Parameters& owner, const std::vector<std::string>& names) {
  const input::Parameters* list = &owner;
  for (std::size_t i = 2; i + 1 < names.size(); ++i) {
    const auto& all = list->sublists();
    const auto found = std::find_if(all.begin(), all.end(), [&](const input::Parameters::Sublist& sublist) {
      return sublist.name == names[i] && !sublist.isNamed;
    });
    if (found == all.end()) return nullptr;
    list = &found->lists.front();
  }
  return list;
}

/// Nothing where there is no such list or number.
std::optional<double> numberIn(const input::Parameters& list, const std::string& name) {
  for (const input::Parameters::Entry& entry : list.entries()) {
    if (entry.name != name) continue;
    if (const auto* number = std::get_if<double>(&entry.value)) return *number;
  }
  return std::nullopt;
}

std::vector<std::string> numbersOf(const input::Parameters& list) {
  std::vector<std::string> names;
  for (const input::Parameters::Entry& entry : list.entries()) {
    if (std::holds_alternative<double>(entry.value)) names.push_back(entry.name);
  }
  return names;
}

[[noreturn]] void refuse(const std::string& entry, const std::string& reason) {
  throw base::Error("\"" + entry + "\": " + reason, base::ExitCode::input);
}

void demandLawEntry(const input::InputTree& input, const std::string& entry) {
  const std::vector<std::string> names = split(entry);
  if (isOfLaw(names)) return;
  if (names.size() != 2 || names[0] != "Values") {
    refuse(entry,
           "only numbers of laws can be parameters: Interfaces/NAME/Law/ENTRY, Boundaries/NAME/Law/ENTRY, "
           "Fields/NAME/Coefficients/ENTRY, or Values/NAME that such entries name.");
  }
  const input::References references(input);
  for (const std::string& user : references.to("$" + names[1])) {
    if (!isOfLaw(split(user))) refuse(entry, "\"" + user + "\" names it, too, which is no number of a law.");
  }
}

}  // namespace

double lawEntry(const input::InputTree& input, const input::Parameters& scene, const std::string& entry) {
  demandLawEntry(input, entry);
  const std::vector<std::string> names = split(entry);
  const std::string& name = names.back();
  const input::Parameters* list = nullptr;
  if (names[0] == "Values") {
    if (scene.hasList("Values")) list = &scene.list("Values");
  } else {
    std::vector<std::string> known;
    bool isKnown = false;
    for (const input::Parameters& owner : scene.lists(names[0])) {
      known.push_back(owner.name());
      if (owner.name() != names[1]) continue;
      isKnown = true;
      list = listOf(owner, names);
    }
    if (!isKnown) refuse(entry, "there is no \"" + names[1] + "\". " + base::suggestName(names[1], known, names[0]));
  }
  if (list != nullptr) {
    if (const auto number = numberIn(*list, name)) return *number;
  }
  refuse(entry, "there is no such number. " +
                    (list == nullptr ? std::string() : base::suggestName(name, numbersOf(*list), "Numbers")));
}

}  // namespace harmos::scene
