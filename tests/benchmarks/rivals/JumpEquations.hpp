#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>

#include "PairNewton.hpp"

namespace harmos::benchmarks {

/// Of all contact pairs: jumps w (n, t1, t2) [length] and the forces (p, -q) on them [force].
struct JumpState {
  std::vector<base::Vector3> jump;
  std::vector<base::Vector3> force;
};

/// Equilibrium of a joint with linear equations for its contact pairs: one step of Newton's method.
class JumpEquations {
 public:
  virtual ~JumpEquations() = default;
  /// Takes the amplitudes of the load cases at a load step.
  virtual void load(const double* amplitudes) = 0;
  /// Solves; `state` is the start of iterative solvers and becomes the solution, with forces from equilibrium.
  /// accuracy: of an iterative solver, the largest norm of what is left [force].
  virtual void solve(const std::vector<PairEquation>& equations, double accuracy, JumpState& state) = 0;
  /// Weight of the jumps of a pair against its forces, see linearise() [force/length].
  virtual double scale(int pair) const = 0;
  /// Linear responses of the joint to the amplitudes last taken and these jumps.
  virtual std::vector<double> responses(const JumpState& state) const = 0;
  /// Matrices factored, and iterations of an iterative solver, so far.
  int factorisations() const { return factorisations_; }
  int linearIterations() const { return linearIterations_; }

 protected:
  int factorisations_ = 0;
  int linearIterations_ = 0;
};

}  // namespace harmos::benchmarks
