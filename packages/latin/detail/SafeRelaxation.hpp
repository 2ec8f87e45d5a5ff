#pragma once

namespace harmos::latin {

/// Relaxation where it must be safe: the mean of a state and its image cannot lie farther from a fixed point than the
/// state when T does not expand.
inline constexpr double safeRelaxation = 0.5;

/// A number of the state moved so far towards that of its image, in their unit.
inline double relaxSafely(double state, double image) {
  return (1.0 - safeRelaxation) * state + safeRelaxation * image;
}

}  // namespace harmos::latin
