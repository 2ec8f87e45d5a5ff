#pragma once

#include <string>
#include <vector>

namespace harmos::design {

/// The values among which a design may choose one parameter: some levels, or everything between two bounds.
struct Axis {
  std::string name;
  std::vector<double> levels;  // empty: any value from lower to upper
  double lower = 0.0;
  double upper = 0.0;

  /// The value at `fraction` of the way, 0 <= fraction < 1; each level takes an equal share.
  double at(double fraction) const;
};

/// `count` equal intervals from `from` to `to`, both included, rounded to 12 digits: 0.15 and not 0.15000000000000002.
/// A count of 1 gives `from`.
std::vector<double> evenLevels(double from, double to, int count);

}  // namespace harmos::design
