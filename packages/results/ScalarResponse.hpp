#pragma once

#include <string>
#include <vector>

namespace harmos::results {

/// A number made of the curve of one of the scene's responses, such as the largest reaction.
struct ScalarResponse {
  /// What is taken of the curve: one of its values at the load steps, with its sign, or the value at a time.
  enum class Kind { maximum, minimum, final, largestMagnitude, atTime };

  std::string name;           // in the study
  std::size_t curve = 0;      // position of the scene's response, from 0
  Kind kind = Kind::maximum;  // which of them
  double time = 0.0;          // of atTime [time]

  /// `values` at `times`, the ends of the load steps. Between them and before the first, where the unloaded state is
  /// taken as 0 at time 0, the curve is linear; after the last it stays. Neither may be empty. The result has the unit
  /// of the curve.
  double evaluate(const std::vector<double>& times, const std::vector<double>& values) const;
};

}  // namespace harmos::results
