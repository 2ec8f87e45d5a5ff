#pragma once

#include <array>
#include <string>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::stochastic {

/// A component of an affine law, with traction t [stress] on side 1 and jump delta [length]: t = stiffness * delta +
/// offset, or delta = offset when the stiffness is infinite.
struct AffineComponent {
  double stiffness = 0.0;  ///< [stress/length]
  double offset = 0.0;     ///< [stress], or [length]
};

/// The components of a law in its frame, found by a probe on lines of the given compliance [length/stress].
///
/// `step`: load step from 0. The probe is at one pair without a gap. Throws base::Error (input) naming the interface
/// when the law is not affine.
std::array<AffineComponent, 3> affineComponents(const laws::InterfaceLaw& law, int step, double compliance,
                                                const std::string& interfaceName);

/// Whether stiffnesses, at least one, do not differ but for the round-off of the probe, 1e-12 of the first.
bool areSame(const std::vector<double>& stiffnesses);

}  // namespace harmos::stochastic
