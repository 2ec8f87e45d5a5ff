#pragma once

#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::scene {

/// The forms of a load history: a factor as a function of time.
std::vector<input::ParameterSpec> historyForms();

/// The factor of one history at each of `times`. Reports tables that do not define a function to `errors`.
std::vector<double> historyFactors(const input::Parameters& history, const std::vector<double>& times,
                                   input::ErrorList& errors);

}  // namespace harmos::scene
