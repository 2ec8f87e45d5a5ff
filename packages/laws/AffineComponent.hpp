#pragma once

#include <array>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::laws {

/// A component of an affine law, with traction t [stress] on side 1 and jump delta [length]: t = stiffness * delta +
/// offset, or delta = offset when the stiffness is infinite.
struct AffineComponent {
  double stiffness = 0.0;  ///< [stress/length], >= 0
  double offset = 0.0;     ///< [stress], or [length]
};

/// The components of an affine law in its frame at a load step, counted from 0, exact but for round-off.
///
/// Found by asking the law at one pair without a gap, on a line of the compliance H [length/stress] > 0 that is given
/// and, where that is far from the law's own, on another. What is stiffer than 1e12 / H is rigid. The law must be
/// isAffine().
std::array<AffineComponent, 3> affineComponents(const InterfaceLaw& law, int step, double compliance);

/// The same where no compliance is at hand, in whatever units: only what gives way on no line at all is rigid.
std::array<AffineComponent, 3> affineComponents(const InterfaceLaw& law, int step);

}  // namespace harmos::laws
