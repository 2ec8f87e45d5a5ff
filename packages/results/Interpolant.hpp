#pragma once

#include <vector>

#include <harmos/probability/HatSum.hpp>

namespace harmos::results {

/// All responses of a study as piecewise linear functions of germs, with error bars: one standard deviation of response
/// r is calibrations[r] doubt_r + floors[r].
struct Interpolant {
  probability::HatSum values;        // in the units of the responses
  probability::HatSum doubt;         // see probability::PiecewiseLinear::doubt()
  std::vector<double> calibrations;  // per response [-], so that 95 % of known errors lie within 1.96 deviations
  std::vector<double> floors;        // per response, in its unit: what the solutions themselves may be off
};

}  // namespace harmos::results
