#include <harmos/elasticity/detail/MaterialEntries.hpp>

namespace harmos::elasticity {

void describeDensity(input::ParameterSpec& spec) {
  spec.number("Density")
      .unit("mass/volume")
      .optional()
      .above(0.0)
      .doc("rho, for Loads; in the units of stress, length and time: with N, mm and s in t/mm^3, steel 7.85e-9.");
}

void describeExpansion(input::ParameterSpec& spec, const std::string& name, const std::string& doc) {
  spec.number(name).unit("1/temperature").optional().doc(doc);
}

std::optional<double> optionalNumber(const input::Parameters& parameters, const std::string& name) {
  if (!parameters.has(name)) return std::nullopt;
  return parameters.number(name);
}

}  // namespace harmos::elasticity
