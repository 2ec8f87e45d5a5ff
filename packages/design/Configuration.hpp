#pragma once

#include <vector>

namespace harmos::design {

/// Of one study; all of them are held in memory before the first is solved.
constexpr int mostConfigurations = 1000000;

/// One point of a design.
struct Configuration {
  int id = 0;                  // 1, 2, .. in the order of the design: the row of the study file
  std::vector<double> values;  // of the study's parameters, in their order and units
};

}  // namespace harmos::design
