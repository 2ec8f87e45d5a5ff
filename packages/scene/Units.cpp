#include <harmos/scene/detail/Units.hpp>

#include <algorithm>
#include <array>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::scene {

namespace {

struct UnitSystem {
  const char* name;
  double stress;  // its unit of stress [Pa]
};

// packages/python/harmos/exchange/units.py has the same, for imports.
constexpr std::array<UnitSystem, 8> systems = {{{"mm N s", 1e6},
                                                {"m N s", 1.0},
                                                {"mm kN s", 1e9},
                                                {"m kN s", 1e3},
                                                {"m MN s", 1e6},
                                                {"cm N s", 1e4},
                                                {"um uN s", 1e6},
                                                {"in lbf s", 6894.757293168361}}};

// [Pa] Soft rubber has 1e6, diamond 1.2e12; woods, plastics and metals lie in the narrow range.
constexpr double softest = 1e6, stiffest = 1.3e12;
constexpr double usuallySoftest = 1e9, usuallyStiffest = 4.2e11;

bool isUsual(double modulus) {
  return modulus >= usuallySoftest && modulus <= usuallyStiffest;
}

/// What to do about a modulus that no solid has in the units `given`.
std::string repair(double value, const std::string& given) {
  std::vector<std::string> names;
  for (const UnitSystem& system : systems) {
    if (system.name != given && isUsual(value * system.stress)) names.push_back(base::quoted(system.name));
  }
  if (names.empty()) return "Check the number.";
  return "It is a usual one in " + base::joinNames(names) + ": change the number or the units.";
}

}  // namespace

std::vector<std::string> unitSystems() {
  std::vector<std::string> names;
  for (const UnitSystem& system : systems) names.emplace_back(system.name);
  return names;
}

std::vector<std::string> implausibleNumbers(const input::Parameters& scene) {
  std::vector<std::string> sentences;
  if (!scene.has("Units")) return sentences;
  const std::string& units = scene.text("Units");
  const auto* system = std::find_if(systems.begin(), systems.end(), [&](const auto& s) { return units == s.name; });
  if (system == systems.end()) return sentences;
  for (const input::Parameters& material : scene.lists("Materials")) {
    for (const std::string entry : {"Young's Modulus", "Young's Modulus 1", "Young's Modulus 2", "Young's Modulus 3"}) {
      if (!material.has(entry)) continue;
      const double modulus = material.number(entry) * system->stress;
      if (modulus >= softest && modulus <= stiffest) continue;
      sentences.push_back(material.where(entry) + ": in the units " + base::quoted(units) + " this is " +
                          base::toText(modulus) + " Pa, " +
                          (modulus > stiffest ? "more than diamond has. " : "less than soft rubber has. ") +
                          repair(material.number(entry), units));
    }
  }
  return sentences;
}

}  // namespace harmos::scene
