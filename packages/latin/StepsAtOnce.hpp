#pragma once

namespace harmos::latin {

/// Load steps, at most, of which what is large is kept together: differences of a march, directions of a
/// CausalCorrection, inner displacements, stresses.
inline constexpr int stepsAtOnce = 64;

}  // namespace harmos::latin
