#include "SparseEquations.hpp"

#include <algorithm>

namespace harmos::benchmarks {

SparseEquations::SparseEquations(const JointSystem& system)
    : system_(system), matrix_(system.matrix()), factor_(matrix_, Mumps::Kind::general), x_(system.unknowns(), 1) {
  for (int p = 0; p < system.pairs(); ++p) {
    const int row = system.firstJump() + 3 * p;
    const std::size_t diagonal = std::lower_bound(matrix_.columns.begin() + matrix_.pointers[row],
                                                  matrix_.columns.begin() + matrix_.pointers[row + 1], row) -
                                 matrix_.columns.begin();
    scale_.push_back(matrix_.values[diagonal]);
  }
}

void SparseEquations::load(const double* amplitudes) {
  const base::Matrix& forces = system_.forces();
  amplitudes_.assign(amplitudes, amplitudes + forces.numCols());
  force_.assign(system_.unknowns(), 0.0);
  for (int k = 0; k < forces.numCols(); ++k) {
    for (int i = 0; i < forces.numRows(); ++i) force_[i] += amplitudes[k] * forces(i, k);
  }
}

void SparseEquations::hold(int row, double value) {
  for (std::size_t k = matrix_.pointers[row]; k < matrix_.pointers[row + 1]; ++k)
    matrix_.values[k] = matrix_.columns[k] == row ? scale_[(row - system_.firstJump()) / 3] : 0.0;
  x_(row, 0) = scale_[(row - system_.firstJump()) / 3] * value;
}

void SparseEquations::slip(int pair, const PairEquation& equation) {
  // K_t x + L (w_t - from) + v (K_n x - f_n) + h = f_t; the rows of a pair have one structure.
  const SparseMatrix& k = system_.matrix();
  const int normal = system_.firstJump() + 3 * pair;
  const std::size_t width = k.pointers[normal + 1] - k.pointers[normal];
  for (int i = 0; i < 2; ++i) {
    const int row = normal + 1 + i;
    for (std::size_t e = 0; e < width; ++e) {
      const int column = k.columns[k.pointers[row] + e];
      double& value = matrix_.values[k.pointers[row] + e];
      value = k.values[k.pointers[row] + e] + equation.pull[i] * k.values[k.pointers[normal] + e];
      if (column == normal + 1 || column == normal + 2) value += equation.stiffness[i][column - normal - 1];
    }
    x_(row, 0) = force_[row] + equation.pull[i] * force_[normal] - equation.constant[i];
    for (int d = 0; d < 2; ++d) x_(row, 0) += equation.stiffness[i][d] * equation.from[d];
  }
  hold(normal, equation.held[0]);
}

void SparseEquations::solve(const std::vector<PairEquation>& equations, double /*accuracy*/, JumpState& state) {
  const int first = system_.firstJump();
  std::copy(force_.begin(), force_.end(), x_.values());
  const SparseMatrix& k = system_.matrix();
  std::copy(k.values.begin() + k.pointers[first], k.values.end(), matrix_.values.begin() + k.pointers[first]);
  for (int p = 0; p < system_.pairs(); ++p) {
    if (equations[p].motion == PairEquation::Motion::stick) {
      for (int c = 0; c < 3; ++c) hold(first + 3 * p + c, equations[p].held[c]);
    } else if (equations[p].motion == PairEquation::Motion::slip) {
      slip(p, equations[p]);
    }
  }
  factor_.factor(matrix_);
  ++factorisations_;
  factor_.solve(x_);
  for (int p = 0; p < system_.pairs(); ++p) {
    for (int c = 0; c < 3; ++c) {
      const int row = first + 3 * p + c;
      state.jump[p][c] = x_(row, 0);
      state.force[p][c] = k.product(row, x_.values()) - force_[row];
    }
  }
}

std::vector<double> SparseEquations::responses(const JumpState& /*state*/) const {
  std::vector<double> result;
  for (int r = 0; r < system_.readers().numCols(); ++r) {
    double value = 0.0;
    for (int i = 0; i < system_.unknowns(); ++i) value += system_.readers()(i, r) * x_(i, 0);
    for (std::size_t k = 0; k < amplitudes_.size(); ++k)
      value += system_.offsets()(static_cast<int>(k), r) * amplitudes_[k];
    result.push_back(value);
  }
  return result;
}

}  // namespace harmos::benchmarks
