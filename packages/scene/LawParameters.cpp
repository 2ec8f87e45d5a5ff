#include <harmos/scene/LawParameters.hpp>

#include <cmath>
#include <utility>

#include <harmos/base/Error.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/laws/FaceLaw.hpp>
#include <harmos/scene/TurnedPlaces.hpp>
#include <harmos/scene/detail/LawEntry.hpp>

namespace harmos::scene {
namespace {

// Of a value: leaves ten digits of a central difference of a smooth law.
constexpr double relativeStep = 1e-6;

}  // namespace

void useLaws(const Scene& scene, assembly::Assembly& assembly) {
  demandPlaces(assembly, scene.laws);
  for (assembly::Interface& interface : assembly.interfaces) {
    const auto law = scene.laws.find(interface.name);
    if (law == scene.laws.end()) continue;  // a cut through a part, which no entry changes
    interface.law = laws::inPlaceOf(*interface.law, law->second);
  }
}

LawParameters::LawParameters(input::InputTree input, std::string path, std::vector<std::string> overrides,
                             const laws::LawRegistry& laws, assembly::Assembly& assembly)
    : input_(std::move(input)),
      path_(std::move(path)),
      overrides_(std::move(overrides)),
      laws_(laws),
      assembly_(assembly),
      scene_(makeScene(input_, path_, overrides_, laws_)),
      given_(scene_.input) {}

double LawParameters::value(const std::string& entry) const {
  return lawEntry(input_, scene_.input, entry);
}

void LawParameters::set(const std::string& entry, double value) {
  lawEntry(input_, scene_.input, entry);  // may throw
  std::map<std::string, double> changes = changes_;
  changes[entry] = value;
  // Another entry may stand for it, as Values/NAME does, and is to be felt again.
  if (value == lawEntry(input_, given_, entry)) changes.erase(entry);
  std::vector<std::string> overrides = overrides_;
  for (const auto& [path, number] : changes) overrides.push_back(path + "=" + base::toText(number));
  Scene changed = makeScene(input_, path_, overrides, laws_);
  useLaws(changed, assembly_);  // refuses before it changes anything
  scene_ = std::move(changed);
  changes_ = std::move(changes);
}

bool LawParameters::isAdmissible(const std::string& entry, double number) {
  const double present = value(entry);
  try {
    set(entry, number);
  } catch (const base::Error&) {
    return false;
  }
  set(entry, present);
  return true;
}

latin::ModelParameter LawParameters::parameter(const std::string& entry) {
  using Side = latin::ModelParameter::Side;
  const double present = value(entry), step = relativeStep * std::abs(present);
  const double beside = present == 0.0 ? relativeStep : step;
  const bool below = isAdmissible(entry, present - beside), above = isAdmissible(entry, present + beside);
  return {entry, present, step, [this, entry](double number) { set(entry, number); },
          below == above ? Side::both
          : above        ? Side::above
                         : Side::below};
}

}  // namespace harmos::scene
