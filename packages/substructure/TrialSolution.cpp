#include <harmos/substructure/detail/TrialSolution.hpp>

#include <cmath>
#include <random>

namespace harmos::substructure {
namespace {

// Residual of a random right-hand side, times the square root of the unknowns, above which a matrix is singular.
constexpr double singularResidual = 1e-3;

}  // namespace

base::Matrix randomForces(int rows, int columns) {
  base::Matrix b(rows, columns);
  std::mt19937 random;  // its sequence is fixed by the standard, that of the distributions is not
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows; ++row) b(row, j) = random() / 2147483648.0 - 1.0;
  }
  return b;
}

Definiteness judge(const base::Matrix& b, const base::Matrix& x, const base::Matrix& residual) {
  double norm = 0.0, energy = 0.0;
  for (int row = 0; row < b.numRows(); ++row) {
    norm += b(row, 0) * b(row, 0);
    energy += b(row, 0) * x(row, 0);
  }
  const double limit = singularResidual / std::sqrt(static_cast<double>(b.numRows()));
  if (!(residual.normFrobenius() / std::sqrt(norm) <= limit)) return Definiteness::singular;
  return energy > 0.0 ? Definiteness::positive : Definiteness::indefinite;
}

}  // namespace harmos::substructure
