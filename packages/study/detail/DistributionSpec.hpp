#pragma once

#include <memory>
#include <string>
#include <vector>

#include <harmos/input/ErrorList.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>
#include <harmos/probability/Distribution.hpp>

namespace harmos::study {

/// The alternatives of the list "Distribution" of a study's parameter.
std::vector<input::ParameterSpec> distributionForms();

/// The distribution that such a list describes; null when it has errors, which are then reported. `directory`: of the
/// study's file, from which a table is looked for; `parameter` heads its column there.
std::shared_ptr<const probability::Distribution> readDistribution(const input::Parameters& list,
                                                                  const std::string& parameter,
                                                                  const std::string& directory,
                                                                  input::ErrorList& errors);

/// The file that a sample is read from, named relative to `directory`; empty when there is none.
std::string sampleFileOf(const input::Parameters& list, const std::string& directory);

}  // namespace harmos::study
