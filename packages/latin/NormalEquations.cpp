#include <harmos/latin/NormalEquations.hpp>

#include <cmath>
#include <numeric>

namespace harmos::latin {

std::vector<double> solveNormalEquations(const base::Matrix& gram, int size, const double* right, double floor) {
  // Squares of relative distances below this are round-off of the products.
  constexpr double independence = 1e-13;
  const auto n = static_cast<std::size_t>(size);
  std::vector<double> scale(n);
  for (int i = 0; i < size; ++i)
    scale[static_cast<std::size_t>(i)] = gram(i, i) > floor ? 1.0 / std::sqrt(gram(i, i)) : 0.0;

  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  base::Matrix factor(size, size);  // row i belongs to order[i]
  std::vector<double> rest(n);
  for (std::size_t i = 0; i < n; ++i) rest[i] = scale[i] > 0.0 ? 1.0 : 0.0;
  int rank = 0;
  for (; rank < size; ++rank) {
    int pivot = rank;
    for (int i = rank; i < size; ++i) {
      if (rest[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] >
          rest[static_cast<std::size_t>(order[static_cast<std::size_t>(pivot)])])
        pivot = i;
    }
    const double square = rest[static_cast<std::size_t>(order[static_cast<std::size_t>(pivot)])];
    if (square < independence) break;
    std::swap(order[static_cast<std::size_t>(rank)], order[static_cast<std::size_t>(pivot)]);
    for (int j = 0; j < rank; ++j) std::swap(factor(rank, j), factor(pivot, j));
    const int column = order[static_cast<std::size_t>(rank)];
    const double diagonal = std::sqrt(square);
    factor(rank, rank) = diagonal;
    for (int i = rank + 1; i < size; ++i) {
      const int row = order[static_cast<std::size_t>(i)];
      double value = gram(row, column) * scale[static_cast<std::size_t>(row)] * scale[static_cast<std::size_t>(column)];
      for (int j = 0; j < rank; ++j) value -= factor(i, j) * factor(rank, j);
      factor(i, rank) = value / diagonal;
      rest[static_cast<std::size_t>(row)] -= factor(i, rank) * factor(i, rank);
    }
  }

  std::vector<double> y(static_cast<std::size_t>(rank));
  for (int i = 0; i < rank; ++i) {
    const auto row = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
    double value = scale[row] * right[row];
    for (int j = 0; j < i; ++j) value -= factor(i, j) * y[static_cast<std::size_t>(j)];
    y[static_cast<std::size_t>(i)] = value / factor(i, i);
  }
  std::vector<double> result(n, 0.0);
  for (int i = rank - 1; i >= 0; --i) {
    double value = y[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < rank; ++j) value -= factor(j, i) * y[static_cast<std::size_t>(j)];
    y[static_cast<std::size_t>(i)] = value / factor(i, i);
    const auto row = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
    result[row] = scale[row] * y[static_cast<std::size_t>(i)];
  }
  return result;
}

}  // namespace harmos::latin
