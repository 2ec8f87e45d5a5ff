#pragma once

#include <memory>

#include "JointSystem.hpp"
#include "JumpEquations.hpp"
#include "Mumps.hpp"

namespace harmos::benchmarks {

/// All unknowns of the joint at once, one sparse factorisation by MUMPS per step of Newton's method. The structure is
/// analysed once: held jumps keep their rows.
class SparseEquations : public JumpEquations {
 public:
  /// `system` must outlive it.
  explicit SparseEquations(const JointSystem& system);
  void load(const double* amplitudes) override;
  void solve(const std::vector<PairEquation>& equations, double accuracy, JumpState& state) override;
  double scale(int pair) const override { return scale_[pair]; }
  std::vector<double> responses(const JumpState& state) const override;

 private:
  void hold(int row, double value);
  void slip(int pair, const PairEquation& equation);

  const JointSystem& system_;
  SparseMatrix matrix_;
  Mumps factor_;
  std::vector<double> scale_;
  std::vector<double> amplitudes_, force_;
  base::Matrix x_;
};

}  // namespace harmos::benchmarks
