#pragma once

#include <vector>

#include "JointSystem.hpp"
#include "JumpEquations.hpp"

namespace harmos::benchmarks {

/// The joint condensed once to its contact jumps, S w = r + forces, by a Schur complement of MUMPS. A step of Newton's
/// method is an equation for the jumps that move, solved by GMRES with the LU factors of an earlier such equation, in
/// single precision, as preconditioner.
class CondensedEquations : public JumpEquations {
 public:
  /// Condenses; `system` is not kept.
  explicit CondensedEquations(const JointSystem& system);
  void load(const double* amplitudes) override;
  void solve(const std::vector<PairEquation>& equations, double accuracy, JumpState& state) override;
  double scale(int pair) const override { return stiffness_(3 * pair, 3 * pair); }
  std::vector<double> responses(const JumpState& state) const override;

 private:
  /// Which jumps move, ascending, and the matrix of their equations.
  void gather(const std::vector<PairEquation>& equations);
  void factor();
  /// z = P r with the factors that there are.
  void precondition(const std::vector<double>& r, std::vector<double>& z);
  /// S (w - last equilibrium's), with forces of the last equilibrium, gives those of this one.
  void balance(JumpState& state);

  base::Matrix stiffness_;  // S
  base::Matrix forces_;     // r of a unit of each case
  base::Matrix readers_, offsets_;
  std::vector<double> amplitudes_, force_;
  std::vector<double> jump_, internal_;  // of the last equilibrium: w and S w

  std::vector<int> moving_;
  base::Matrix matrix_;
  std::vector<float> factors_;
  std::vector<int> pivots_, factored_;  // of the jumps that moved then
  std::vector<int> places_;             // of jumps in factored_, or -1
  std::vector<float> work_;
  int lastIterations_ = 0;
};

}  // namespace harmos::benchmarks
