#include <harmos/latin/detail/RowAlgebra.hpp>

#include <cmath>

#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {

double dot(const Row& a, const Row& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(double factor, const Row& x, Row& to) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * x[i];
}

base::Matrix productsOf(const std::vector<Row>& rows) {
  const int count = static_cast<int>(rows.size());
  base::Matrix products(count, count);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) products(i, j) = dot(rows[i], rows[j]);
  }
  return products;
}

std::vector<Row> basisOf(const std::vector<Row>& rows, double none) {
  std::vector<Row> basis;
  if (rows.empty()) return basis;
  base::Matrix modes = productsOf(rows);
  const Row values = symmetricEigen(modes);
  for (int j = 0; j < modes.numCols(); ++j) {
    if (values[j] <= none) continue;
    basis.emplace_back(rows.front().size(), 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) add(modes[j][i] / std::sqrt(values[j]), rows[i], basis.back());
  }
  return basis;
}

}  // namespace harmos::latin
