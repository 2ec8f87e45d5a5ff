#include <harmos/scene/detail/Units.hpp>

#include <algorithm>
#include <array>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>

namespace harmos::scene {

namespace {

struct UnitSystem {
  const char* name;
  double stress;   // its unit of stress [Pa]
  double density;  // its unit of force time^2 / length^4 [kg/m^3]
};

// packages/python/harmos/exchange/units.py has the same, for imports.
constexpr std::array<UnitSystem, 8> systems = {{{"mm N s", 1e6, 1e12},
                                                {"m N s", 1.0, 1.0},
                                                {"mm kN s", 1e9, 1e15},
                                                {"m kN s", 1e3, 1e3},
                                                {"m MN s", 1e6, 1e6},
                                                {"cm N s", 1e4, 1e8},
                                                {"um uN s", 1e6, 1e18},
                                                {"in lbf s", 6894.757293168361, 1.0686895e7}}};

/// A number of a material that tells its units.
struct Quantity {
  double UnitSystem::*unit;
  const char* name;
  double least, largest;  // that solids have
  const char *tooSmall, *tooLarge;
  double usuallyLeast, usuallyLargest;  // of woods, plastics and metals
};

constexpr Quantity modulus = {&UnitSystem::stress,       "Pa", 1e6,   1.3e12, "less than soft rubber has. ",
                              "more than diamond has. ", 1e9,  4.2e11};
constexpr Quantity density = {&UnitSystem::density,     "kg/m^3", 1.0,  3e4, "less than aerogel has. ",
                              "more than osmium has. ", 300.0,    2.3e4};

struct Entry {
  const char* name;
  const Quantity* quantity;
};

constexpr std::array<Entry, 5> entries = {{{"Young's Modulus", &modulus},
                                           {"Young's Modulus 1", &modulus},
                                           {"Young's Modulus 2", &modulus},
                                           {"Young's Modulus 3", &modulus},
                                           {"Density", &density}}};

/// What to do about a number that no solid has in the units `given`.
std::string repair(const Quantity& quantity, double value, const std::string& given) {
  std::vector<std::string> names;
  for (const UnitSystem& system : systems) {
    const double size = value * system.*quantity.unit;
    const bool isUsual = size >= quantity.usuallyLeast && size <= quantity.usuallyLargest;
    if (system.name != given && isUsual) names.push_back(base::quoted(system.name));
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
    for (const auto& [entry, quantity] : entries) {
      if (!material.has(entry)) continue;
      const double value = material.number(entry), size = value * (*system).*quantity->unit;
      if ((size >= quantity->least && size <= quantity->largest) || value == 0.0) continue;
      sentences.push_back(material.where(entry) + ": in the units " + base::quoted(units) + " this is " +
                          base::toText(size) + " " + quantity->name + ", " +
                          (size > quantity->largest ? quantity->tooLarge : quantity->tooSmall) +
                          repair(*quantity, value, units));
    }
  }
  return sentences;
}

}  // namespace harmos::scene
