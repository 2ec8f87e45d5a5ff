#include "Gmres.hpp"

#include <cmath>
#include <cstddef>

namespace harmos::benchmarks {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(double factor, const std::vector<double>& a, std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) b[i] += factor * a[i];
}

}  // namespace

int solveByGmres(const LinearMap& matrix, const LinearMap& preconditioner, const std::vector<double>& b,
                 double accuracy, int limit, std::vector<double>& x) {
  std::vector<double> residual(b.size()), z(b.size());
  matrix(x, residual);
  for (std::size_t i = 0; i < b.size(); ++i) residual[i] = b[i] - residual[i];
  const double start = std::sqrt(dot(residual, residual));
  if (start <= accuracy) return 0;
  for (double& value : residual) value /= start;
  std::vector<std::vector<double>> basis{residual}, columns;
  std::vector<double> cosine, sine, right{start};
  int count = 0;
  while (std::abs(right.back()) > accuracy && count < limit) {
    preconditioner(basis.back(), z);
    std::vector<double> next(b.size());
    matrix(z, next);
    std::vector<double> column;
    for (const auto& vector : basis) {
      column.push_back(dot(vector, next));
      add(-column.back(), vector, next);
    }
    const double length = std::sqrt(dot(next, next));
    for (int i = 0; i < count; ++i) {
      const double above = column[i];
      column[i] = cosine[i] * above + sine[i] * column[i + 1];
      column[i + 1] = cosine[i] * column[i + 1] - sine[i] * above;
    }
    const double size = std::hypot(column[count], length);
    cosine.push_back(column[count] / size);
    sine.push_back(length / size);
    column[count] = size;
    right.push_back(-sine[count] * right[count]);
    right[count] *= cosine[count];
    columns.push_back(column);
    ++count;
    if (length == 0.0) break;
    for (double& value : next) value /= length;
    basis.push_back(next);
  }
  std::vector<double> sum(b.size(), 0.0), weights(count);
  for (int i = count - 1; i >= 0; --i) {
    weights[i] = right[i];
    for (int j = i + 1; j < count; ++j) weights[i] -= columns[j][i] * weights[j];
    weights[i] /= columns[i][i];
    add(weights[i], basis[i], sum);
  }
  preconditioner(sum, z);
  add(1.0, z, x);
  return count;
}

}  // namespace harmos::benchmarks
