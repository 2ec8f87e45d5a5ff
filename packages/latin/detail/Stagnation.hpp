#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace harmos::latin {

/// Foresees from the best residuals of an iteration how many more it takes.
class Stagnation {
 public:
  /// Iterations from whose gain the future is foreseen.
  static constexpr std::size_t window = 25;
  /// More than so many further iterations are too many.
  static constexpr double patience = 150.0;

  /// Whether an iteration that now has this residual takes too long to get to `target`, of one unit; false before a
  /// whole window has passed.
  bool isFound(double residual, double target) {
    best_.push_back(best_.empty() ? residual : std::min(best_.back(), residual));
    if (best_.size() <= window) return false;
    const double gain = std::log(best_[best_.size() - 1 - window] / best_.back()) / static_cast<double>(window);
    return std::log(best_.back() / target) > patience * gain;
  }

 private:
  std::vector<double> best_;  // up to each iteration
};

}  // namespace harmos::latin
