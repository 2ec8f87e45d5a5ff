#pragma once

#include <string>
#include <vector>

namespace harmos::design {

/// The values among which a design may choose one parameter: some levels, or everything between two bounds.
struct Axis {
  std::string name;            // of the parameter
  std::vector<double> levels;  // in the unit of the parameter; empty: any value from lower to upper
  double lower = 0.0;          // in the unit of the parameter; counts without levels only
  double upper = 0.0;          // the same, not below lower

  /// The value at `fraction` of the way, 0 <= fraction < 1; each level takes an equal share.
  double at(double fraction) const;
};

/// `count` evenly spaced values from `from` to `to`, both included, rounded to 12 digits: 0.15 and not
/// 0.15000000000000002. A count of 1 gives `from`.
std::vector<double> evenLevels(double from, double to, int count);

}  // namespace harmos::design
