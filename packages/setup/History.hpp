#pragma once

#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/ParameterSpec.hpp>
#include <harmos/base/Parameters.hpp>

namespace harmos::setup {

/// The forms of a load history: a factor as a function of time.
std::vector<base::ParameterSpec> historyForms();

/// The factor of one history at each of `times`. Reports tables that do not define a function to `errors`.
std::vector<double> historyFactors(const base::Parameters& history, const std::vector<double>& times,
                                   base::ErrorList& errors);

}  // namespace harmos::setup
