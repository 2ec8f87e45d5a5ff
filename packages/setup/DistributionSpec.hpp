#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/base/ErrorList.hpp>
#include <harmos/base/ParameterSpec.hpp>
#include <harmos/base/Parameters.hpp>
#include <harmos/chaos/Distribution.hpp>

namespace harmos::setup {

/// The alternatives of the list "Distribution" of a study's parameter.
std::vector<base::ParameterSpec> distributionForms();

/// The distribution that such a list describes; null when it has errors, which are then reported. `directory`: of the
/// study's file, from which a table is looked for; `parameter` heads its column there.
std::shared_ptr<const chaos::Distribution> readDistribution(const base::Parameters& list, const std::string& parameter,
                                                            const std::string& directory, base::ErrorList& errors);

}  // namespace harmos::setup
