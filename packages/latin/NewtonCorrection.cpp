#include <harmos/latin/NewtonCorrection.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <Teuchos_LAPACK.hpp>

namespace harmos::latin {
namespace {

using base::Matrix;

// A residual below this share of the state is that of a fixed point.
constexpr double roundOff = 1e-14;

void add(Matrix& to, double factor, const Matrix& x) {
  for (int t = 0; t < to.numCols(); ++t) {
    for (int row = 0; row < to.numRows(); ++row) to[t][row] += factor * x[t][row];
  }
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): LAPACK overwrites it
double smallestSingularValue(Matrix matrix) {
  const int n = matrix.numCols();
  if (n == 0) return 0.0;
  std::vector<double> values(static_cast<std::size_t>(n));
  std::vector<double> work(static_cast<std::size_t>(10 * (n + 2)));
  double unused = 0.0;
  int info = 0;
  Teuchos::LAPACK<int, double>().GESVD('N', 'N', matrix.numRows(), n, matrix.values(), matrix.stride(), values.data(),
                                       &unused, 1, &unused, 1, work.data(), static_cast<int>(work.size()), nullptr,
                                       &info);
  return info == 0 ? values.back() : 0.0;
}

/// Least squares min |beta e1 - H y|; returns the residual's norm.
double solveHessenberg(const Matrix& hessenberg, int columns, double beta, std::vector<double>& y) {
  Matrix h(Teuchos::Copy, hessenberg, columns + 1, columns);
  std::vector<double> right(static_cast<std::size_t>(columns) + 1, 0.0);
  right[0] = beta;
  std::vector<double> work(static_cast<std::size_t>(64 * (columns + 1)));
  int info = 0;
  Teuchos::LAPACK<int, double>().GELS('N', columns + 1, columns, 1, h.values(), h.stride(), right.data(), columns + 1,
                                      work.data(), static_cast<int>(work.size()), &info);
  y.assign(right.begin(), right.begin() + columns);
  return std::abs(right[static_cast<std::size_t>(columns)]);
}

}  // namespace

NewtonCorrection::Result NewtonCorrection::solve(const Matrix& alpha, const Matrix& image, double target) {
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
  // Small enough for the tangent, large enough for the round-off of T.
  const double difference = 1e-6 * size;

  std::vector<Matrix> basis;
  Matrix hessenberg(maximum_ + 1, maximum_);
  residual.scale(1.0 / beta);
  basis.push_back(residual);
  std::vector<double> y;
  Matrix shifted(alpha.numRows(), alpha.numCols());
  Matrix moved(alpha.numRows(), alpha.numCols());
  int n = 0;
  while (n < maximum_) {
    shifted.assign(alpha);
    add(shifted, difference, basis[static_cast<std::size_t>(n)]);
    fixedPoint_.apply(shifted, moved);
    Matrix next(basis[static_cast<std::size_t>(n)]);
    add(next, -1.0 / difference, moved);
    add(next, 1.0 / difference, image);
    for (int pass = 0; pass < 2; ++pass) {
      for (int j = 0; j <= n; ++j) {
        const double h = metric.dot(basis[static_cast<std::size_t>(j)], next);
        hessenberg(j, n) += h;
        add(next, -h, basis[static_cast<std::size_t>(j)]);
      }
    }
    const double length = metric.norm(next);
    hessenberg(n + 1, n) = length;
    ++n;
    result.reduction = solveHessenberg(hessenberg, n, beta, y) / beta;
    if (result.reduction <= target || length <= 1e-14) break;
    next.scale(1.0 / length);
    basis.push_back(next);
  }
  for (int j = 0; j < n; ++j) add(result.step, y[static_cast<std::size_t>(j)], basis[static_cast<std::size_t>(j)]);
  result.vectors = n;
  result.smallestSingularValue = smallestSingularValue(Matrix(Teuchos::Copy, hessenberg, n + 1, n));
  return result;
}

}  // namespace harmos::latin
