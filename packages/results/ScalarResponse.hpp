#pragma once

#include <string>
#include <vector>

namespace harmos::results {

/// A number made of the curve of one of the scene's responses, such as the largest reaction.
struct ScalarResponse {
  enum class Kind { maximum, minimum, final, largestMagnitude, atTime };

  std::string name;
  std::size_t curve = 0;  // position of the scene's response
  Kind kind = Kind::maximum;
  double time = 0.0;  // of atTime

  /// `values` at `times`, the ends of the load steps. Between them and before the first, where the unloaded state is
  /// taken as 0 at time 0, the curve is linear; after the last it stays.
  double evaluate(const std::vector<double>& times, const std::vector<double>& values) const;
};

}  // namespace harmos::results
