#pragma once

#include <cmath>

namespace harmos::base {

/// Beyond it, and areas below one over it, squares and products of a scene's numbers leave double precision.
inline constexpr double largestNumber = 1e100;

/// Finite, and not beyond it.
inline bool isUsable(double number) {
  return std::abs(number) <= largestNumber;
}

}  // namespace harmos::base
