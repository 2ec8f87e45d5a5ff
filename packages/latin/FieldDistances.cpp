#include <harmos/latin/detail/FieldDistances.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::latin {

std::vector<double> fieldDistances(const StateMetric& metric, const base::Matrix& alpha, const base::Matrix& beta,
                                   const base::ColumnStore& startAlpha, const base::ColumnStore& startBeta) {
  const auto steps = static_cast<std::size_t>(alpha.numCols());
  std::vector<double> sums(4 * steps, 0.0);  // per load step: squares of f and k w, and of their differences
  for (std::size_t t = 0; t < steps; ++t) {
    const auto column = static_cast<int>(t);
    const double *a = alpha[column], *b = beta[column], *a0 = startAlpha.read(column), *b0 = startBeta.read(column);
    for (std::size_t row = 0; row < metric.scale().size(); ++row) {
      const double square = metric.scale()[row] * metric.scale()[row];
      const double da = a[row] - a0[row], db = b[row] - b0[row];
      sums[4 * t] += square * (a[row] + b[row]) * (a[row] + b[row]);
      sums[4 * t + 1] += square * (a[row] - b[row]) * (a[row] - b[row]);
      sums[4 * t + 2] += square * (da + db) * (da + db);
      sums[4 * t + 3] += square * (da - db) * (da - db);
    }
  }
  metric.sum(sums);
  double force = 0.0, displacement = 0.0;
  for (std::size_t t = 0; t < steps; ++t) {
    force = std::max(force, sums[4 * t]);
    displacement = std::max(displacement, sums[4 * t + 1]);
  }
  std::vector<double> distances(steps, 0.0);
  for (std::size_t t = 0; t < steps; ++t) {
    if (force > 0.0) distances[t] = std::sqrt(sums[4 * t + 2] / force);
    if (displacement > 0.0) distances[t] = std::max(distances[t], std::sqrt(sums[4 * t + 3] / displacement));
  }
  return distances;
}

}  // namespace harmos::latin
