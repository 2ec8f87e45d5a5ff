#include <harmos/scene/detail/LawEntry.hpp>

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

bool isOfLaw(const std::vector<std::string>& names) {
  return names.size() == 4 && (names[0] == "Interfaces" || names[0] == "Boundaries") && names[2] == "Law";
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
    refuse(
        entry,
        "only numbers of laws can be parameters: Interfaces/NAME/Law/ENTRY, Boundaries/NAME/Law/ENTRY, or Values/NAME "
        "that such entries name.");
  }
  for (const std::string& user : input::entriesThatName(input, "$" + names[1])) {
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
    for (const input::Parameters& interface : scene.lists(names[0])) {
      known.push_back(interface.name());
      if (interface.name() == names[1]) list = &interface.list("Law");
    }
    if (list == nullptr)
      refuse(entry, "there is no \"" + names[1] + "\". " + base::suggestName(names[1], known, names[0]));
  }
  if (list != nullptr) {
    if (const auto number = numberIn(*list, name)) return *number;
  }
  refuse(entry, "there is no such number. " +
                    (list == nullptr ? std::string() : base::suggestName(name, numbersOf(*list), "Numbers")));
}

}  // namespace harmos::scene
