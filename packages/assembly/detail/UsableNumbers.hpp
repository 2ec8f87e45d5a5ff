#pragma once

#include <cmath>

namespace harmos::assembly {

/// Beyond it, and areas below one over it, squares and products of an assembly's numbers leave double precision.
inline constexpr double largestNumber = 1e100;

/// Finite, and not beyond it.
inline bool isUsable(double number) {
  return std::abs(number) <= largestNumber;
}

}  // namespace harmos::assembly
