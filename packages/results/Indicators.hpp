#pragma once

#include <vector>

namespace harmos::results {

/// What an iteration shows of its own error without a solve; see parametric::Calibration for what it takes to read it.
///
/// All compare the two fields of the LATIN method, which agree at the solution: tractions f of the linear stage, in
/// equilibrium with the bodies, and f^ of the local stage, which obey the interface laws. All are ratios [-]. h: the
/// interface mass [area].
struct Indicators {
  /// |T(alpha) - alpha| / |f^|, both in the state metric: goes with the error of the field of interface forces.
  double force = 0.0;
  /// Largest resultant over bodies and load steps |sum of h (f^ - f)|, by which the tractions f^ fail to balance a
  /// body, relative to the largest resultant of an interface.
  double balance = 0.0;
  /// What both make of each response, see parametric::Gauge: these go with the errors of the responses.
  std::vector<double> responses = {};
};

}  // namespace harmos::results
