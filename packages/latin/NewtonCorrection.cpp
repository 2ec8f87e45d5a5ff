#include <harmos/latin/NewtonCorrection.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <Teuchos_LAPACK.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

// Step of the difference quotients over the interface forces, and its bounds over the state: small beside the forces,
// for the tangent; large beside the round-off of T, which is that of k w.
constexpr double differenceOfForces = 1e-6;
constexpr double leastDifference = 1e-9;
constexpr double largestDifference = 1e-6;
// Length of what a new Krylov vector adds to the others below which it is nothing but round-off.
constexpr double breakdown = 1e-14;
// A residual below this share of the state is that of a fixed point.
constexpr double roundOff = 1e-14;

// Share of the step that the residual may hide.
constexpr double allowedToHide = 0.5;
// Of the largest singular value: less is noise.
constexpr double singular = 1e-7;

double norm(const std::vector<double>& y) {
  return std::sqrt(std::inner_product(y.begin(), y.end(), y.begin(), 0.0));
}

void add(Matrix& to, double factor, const Matrix& x) {
  for (int t = 0; t < to.numCols(); ++t) {
    for (int row = 0; row < to.numRows(); ++row) to[t][row] += factor * x[t][row];
  }
}

/// Least squares min |beta e1 - H y| without what is singular but for the noise of the differences; returns the
/// residual's norm and the smallest singular value that is none.
std::pair<double, double> solveHessenberg(const Matrix& hessenberg, int columns, double beta, std::vector<double>& y) {
  Matrix h(Teuchos::Copy, hessenberg, columns + 1, columns);
  std::vector<double> right(static_cast<std::size_t>(columns) + 1, 0.0), values(columns);
  right[0] = beta;
  std::vector<double> work(64 * (columns + 1));
  int info = 0, rank = 0;
  double unused = 0.0;
  Teuchos::LAPACK<int, double>().GELSS(columns + 1, columns, 1, h.values(), h.stride(), right.data(), columns + 1,
                                       values.data(), singular, &rank, work.data(), static_cast<int>(work.size()),
                                       &unused, &info);
  y.assign(right.begin(), right.begin() + columns);
  std::vector<double> residual(static_cast<std::size_t>(columns) + 1, 0.0);
  residual[0] = beta;
  for (int j = 0; j < columns; ++j) {
    for (int i = 0; i <= columns; ++i) {
      residual[i] -= hessenberg(i, j) * y[j];
    }
  }
  return {norm(residual), rank > 0 ? values[rank - 1] : 0.0};
}

}  // namespace

NewtonCorrection::Result NewtonCorrection::solve(const Iterate& iterate, const Matrix& alpha, const Matrix& image,
                                                 double target, int maximumVectors) {
  const StateMetric& metric = fixedPoint_.metric();
  Result result;
  result.step.shape(alpha.numRows(), alpha.numCols());
  Matrix residual(image);
  add(residual, -1.0, alpha);
  const double beta = metric.norm(residual);
  const double size = std::max(metric.norm(alpha), metric.norm(image));
  if (beta <= roundOff * size) {
    result.reduction = 0.0;
    return result;
  }
  const double forces = metric.norm(iterate.hattedTraction());
  const double difference = std::clamp(differenceOfForces * forces, leastDifference * size, largestDifference * size);

  std::vector<Matrix> basis;
  Matrix hessenberg(maximumVectors + 1, maximumVectors);
  residual.scale(1.0 / beta);
  basis.push_back(residual);
  std::vector<double> y;
  Matrix shifted(alpha.numRows(), alpha.numCols());
  Matrix moved(alpha.numRows(), alpha.numCols());
  int n = 0;
  while (n < maximumVectors) {
    shifted.assign(alpha);
    add(shifted, difference, basis[n]);
    fixedPoint_.apply(shifted, moved);
    Matrix next(basis[n]);
    add(next, -1.0 / difference, moved);
    add(next, 1.0 / difference, image);
    for (int pass = 0; pass < 2; ++pass) {
      for (int j = 0; j <= n; ++j) {
        const double h = metric.dot(basis[j], next);
        hessenberg(j, n) += h;
        add(next, -h, basis[j]);
      }
    }
    const double length = metric.norm(next);
    hessenberg(n + 1, n) = length;
    ++n;
    const auto [left, smallest] = solveHessenberg(hessenberg, n, beta, y);
    result.reduction = left / beta;
    result.smallestSingularValue = smallest;
    slowest_ = std::min(slowest_, smallest);
    result.hidden = left / (slowest_ * norm(y));
    if (length <= breakdown || (result.reduction <= target && result.hidden <= allowedToHide)) break;
    next.scale(1.0 / length);
    basis.push_back(next);
  }
  for (int j = 0; j < n; ++j) add(result.step, y[j], basis[j]);
  result.vectors = n;
  return result;
}

}  // namespace harmos::latin
