#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>

#include "JumpEquations.hpp"

namespace harmos::benchmarks {

/// What a joint answers to its load steps.
struct NewtonResult {
  std::vector<std::vector<double>> responses;  ///< per load step, linear responses in the order of JointSystem
  std::vector<double> pressureForce;           ///< per load step: sum of p over all pairs [force]
  int iterations = 0;
};

/// Load step after load step by the semi-smooth Newton method.
///
/// A step starts from the last two, continued in a straight line, the first one from bonded contacts. It ends when the
/// violation of the laws is at most `residual` times the forces, both as root of the sum of squares over the pairs.
/// amplitudes: cases x load steps; frictions: per load step and pair. Throws base::Error (notConverged) after 60
/// iterations of a step.
NewtonResult marchByNewton(JumpEquations& equations, const base::Matrix& amplitudes,
                           const std::vector<std::vector<double>>& frictions, double residual);

}  // namespace harmos::benchmarks
