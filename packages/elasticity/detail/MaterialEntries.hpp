#pragma once

#include <optional>
#include <string>

#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::elasticity {

/// Declares the density that every material may have.
void describeDensity(input::ParameterSpec& spec);
/// Declares a coefficient of thermal expansion under this name.
void describeExpansion(input::ParameterSpec& spec, const std::string& name, const std::string& doc);
/// A number that need not be given.
std::optional<double> optionalNumber(const input::Parameters& parameters, const std::string& name);

}  // namespace harmos::elasticity
