#pragma once

#include <harmos/design/Configuration.hpp>
#include <harmos/results/ConfigurationResult.hpp>

namespace harmos::parametric {

/// What another run of the same study has recorded of a configuration; of its fields nothing is left.
struct EarlierResult {
  design::Configuration configuration;  ///< its id is that of the result
  results::ConfigurationResult result;  ///< the last that was recorded
};

}  // namespace harmos::parametric
