#include "CondensedEquations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

#include "Gmres.hpp"
#include "Mumps.hpp"

namespace harmos::benchmarks {
namespace {

// New factors when GMRES has taken more iterations than what they cost is worth, or stopped at the limit.
constexpr int manyIterations = 12, limit = 60;

}  // namespace

CondensedEquations::CondensedEquations(const JointSystem& system) {
  const int jumps = system.jumps(), cases = system.forces().numCols(), responses = system.readers().numCols();
  Mumps factor(system.matrix(), Mumps::Kind::positiveDefinite, jumps);
  factor.factor(system.matrix());
  ++factorisations_;
  // Loads and readers are condensed alike, K being symmetric: r = f_w - K_wu y with y = K_uu^-1 f_u.
  base::Matrix columns(system.unknowns(), cases + responses);
  for (int k = 0; k < cases; ++k) std::copy_n(system.forces()[k], system.unknowns(), columns[k]);
  for (int r = 0; r < responses; ++r) std::copy_n(system.readers()[r], system.unknowns(), columns[cases + r]);
  factor.condense(columns);
  const auto condensed = [&](int first, int count) {
    return base::Matrix(Teuchos::Copy, columns, jumps, count, system.firstJump(), first);
  };
  forces_ = condensed(0, cases);
  readers_ = condensed(cases, responses);
  offsets_ = system.offsets();
  for (int k = 0; k < cases; ++k) {
    for (int r = 0; r < responses; ++r) {
      for (int i = 0; i < system.firstJump(); ++i) offsets_(k, r) += system.readers()(i, r) * columns(i, k);
    }
  }
  stiffness_.swap(factor.schur());
  jump_.assign(jumps, 0.0);
  internal_.assign(jumps, 0.0);
  places_.assign(jumps, -1);
}

void CondensedEquations::load(const double* amplitudes) {
  amplitudes_.assign(amplitudes, amplitudes + forces_.numCols());
  force_.assign(forces_.numRows(), 0.0);
  for (int k = 0; k < forces_.numCols(); ++k) {
    for (int i = 0; i < forces_.numRows(); ++i) force_[i] += amplitudes[k] * forces_(i, k);
  }
}

void CondensedEquations::gather(const std::vector<PairEquation>& equations) {
  // The pressure that friction follows enters as the row of the jump along n.
  moving_.clear();
  std::vector<int> normal;
  std::vector<double> pull;
  for (std::size_t p = 0; p < equations.size(); ++p) {
    const PairEquation& equation = equations[p];
    if (equation.motion == PairEquation::Motion::stick) continue;
    const bool slips = equation.motion == PairEquation::Motion::slip;
    for (int c = slips ? 1 : 0; c < 3; ++c) {
      moving_.push_back(3 * static_cast<int>(p) + c);
      normal.push_back(3 * static_cast<int>(p));
      pull.push_back(slips ? equation.pull[c - 1] : 0.0);
    }
  }
  const int count = static_cast<int>(moving_.size());
  matrix_.shapeUninitialized(count, count);
  for (int j = 0; j < count; ++j) {
    const double* from = stiffness_[moving_[j]];
    double* to = matrix_[j];
    for (int i = 0; i < count; ++i) to[i] = from[moving_[i]] + pull[i] * from[normal[i]];
  }
  for (int i = 0; i < count; ++i) {
    const PairEquation& equation = equations[moving_[i] / 3];
    if (equation.motion != PairEquation::Motion::slip) continue;
    const int c = moving_[i] % 3 - 1;  // the two jumps of a pair that slips follow each other
    for (int d = 0; d < 2; ++d) matrix_(i, i - c + d) += equation.stiffness[c][d];
  }
}

void CondensedEquations::factor() {
  const int count = static_cast<int>(moving_.size());
  factors_.assign(matrix_.values(), matrix_.values() + static_cast<std::size_t>(count) * count);
  pivots_.resize(count);
  int info = 0;
  Teuchos::LAPACK<int, float>().GETRF(count, count, factors_.data(), count, pivots_.data(), &info);
  if (info < 0) throw base::Error("LAPACK GETRF returned " + std::to_string(info));
  // Parts that slide everywhere may be as good as loose in single precision; a preconditioner need not be exact.
  float largest = 0.0F;
  const std::size_t toNext = static_cast<std::size_t>(count) + 1;
  for (std::size_t i = 0; i < factors_.size(); i += toNext) largest = std::max(largest, std::abs(factors_[i]));
  const float least = std::numeric_limits<float>::epsilon() * largest;
  for (std::size_t i = 0; i < factors_.size(); i += toNext) {
    if (std::abs(factors_[i]) < least) factors_[i] = std::copysign(least, factors_[i]);
  }
  factored_ = moving_;
  std::fill(places_.begin(), places_.end(), -1);
  for (int i = 0; i < count; ++i) places_[factored_[i]] = i;
  ++factorisations_;
}

void CondensedEquations::precondition(const std::vector<double>& r, std::vector<double>& z) {
  const int count = static_cast<int>(factored_.size());
  work_.assign(count, 0.0F);
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (places_[moving_[i]] >= 0) work_[places_[moving_[i]]] = static_cast<float>(r[i]);
  }
  int info = 0;
  Teuchos::LAPACK<int, float>().GETRS('N', count, 1, factors_.data(), count, pivots_.data(), work_.data(), count,
                                      &info);
  for (std::size_t i = 0; i < r.size(); ++i) {
    const int place = places_[moving_[i]];
    z[i] = place >= 0 ? work_[place] : r[i] / matrix_(static_cast<int>(i), static_cast<int>(i));
  }
}

void CondensedEquations::solve(const std::vector<PairEquation>& equations, double accuracy, JumpState& state) {
  gather(equations);
  for (std::size_t p = 0; p < equations.size(); ++p) {
    if (equations[p].motion == PairEquation::Motion::stick) state.jump[p] = equations[p].held;
    if (equations[p].motion == PairEquation::Motion::slip) state.jump[p][0] = equations[p].held[0];
  }
  if (!moving_.empty()) {
    // In changes of the jumps that move, from those of the start: the start is 0, the right side what is left.
    balance(state);
    const int count = static_cast<int>(moving_.size());
    std::vector<double> left(count), change(count, 0.0);
    for (int i = 0; i < count; ++i) {
      const int pair = moving_[i] / 3, c = moving_[i] % 3;
      const PairEquation& equation = equations[pair];
      left[i] = -state.force[pair][c];
      if (equation.motion != PairEquation::Motion::slip) continue;
      left[i] -= equation.pull[c - 1] * state.force[pair][0] + equation.constant[c - 1];
      for (int d = 0; d < 2; ++d)
        left[i] -= equation.stiffness[c - 1][d] * (state.jump[pair][1 + d] - equation.from[d]);
    }
    const Teuchos::BLAS<int, double> blas;
    const LinearMap matrix = [&](const std::vector<double>& x, std::vector<double>& y) {
      blas.GEMV(Teuchos::NO_TRANS, count, count, 1.0, matrix_.values(), matrix_.stride(), x.data(), 1, 0.0, y.data(),
                1);
    };
    const LinearMap preconditioner = [&](const std::vector<double>& r, std::vector<double>& z) { precondition(r, z); };
    if (factored_.empty() || lastIterations_ > manyIterations) factor();
    lastIterations_ = solveByGmres(matrix, preconditioner, left, accuracy, limit, change);
    linearIterations_ += lastIterations_;
    for (int i = 0; i < count; ++i) state.jump[moving_[i] / 3][moving_[i] % 3] += change[i];
  }
  balance(state);
}

void CondensedEquations::balance(JumpState& state) {
  const Teuchos::BLAS<int, double> blas;
  const int jumps = stiffness_.numRows();
  for (int j = 0; j < jumps; ++j) {
    const double change = state.jump[j / 3][j % 3] - jump_[j];
    if (change == 0.0) continue;
    blas.AXPY(jumps, change, stiffness_[j], 1, internal_.data(), 1);
    jump_[j] += change;
  }
  for (int j = 0; j < jumps; ++j) state.force[j / 3][j % 3] = internal_[j] - force_[j];
}

std::vector<double> CondensedEquations::responses(const JumpState& state) const {
  std::vector<double> result;
  for (int r = 0; r < readers_.numCols(); ++r) {
    double value = 0.0;
    for (int j = 0; j < readers_.numRows(); ++j) value += readers_(j, r) * state.jump[j / 3][j % 3];
    for (std::size_t k = 0; k < amplitudes_.size(); ++k) value += offsets_(static_cast<int>(k), r) * amplitudes_[k];
    result.push_back(value);
  }
  return result;
}

}  // namespace harmos::benchmarks
