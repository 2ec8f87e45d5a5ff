#include <harmos/latin/NormalEquations.hpp>

#include <cmath>
#include <numeric>

namespace harmos::latin {

std::vector<double> solveNormalEquations(const base::Matrix& gram, int size, const double* right, double floor) {
  // Squares of relative distances below this are round-off of the products.
  constexpr double independence = 1e-13;
  const auto n = static_cast<std::size_t>(size);
  std::vector<double> scale(n);
  for (int i = 0; i < size; ++i) scale[i] = gram(i, i) > floor ? 1.0 / std::sqrt(gram(i, i)) : 0.0;

  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  base::Matrix factor(size, size);  // row i belongs to order[i]
  std::vector<double> rest(n);
  for (std::size_t i = 0; i < n; ++i) rest[i] = scale[i] > 0.0 ? 1.0 : 0.0;
  int rank = 0;
  for (; rank < size; ++rank) {
    int pivot = rank;
    for (int i = rank; i < size; ++i) {
      if (rest[order[i]] > rest[order[pivot]]) pivot = i;
    }
    const double square = rest[order[pivot]];
    if (square < independence) break;
    std::swap(order[rank], order[pivot]);
    for (int j = 0; j < rank; ++j) std::swap(factor(rank, j), factor(pivot, j));
    const int column = order[rank];
    const double diagonal = std::sqrt(square);
    factor(rank, rank) = diagonal;
    for (int i = rank + 1; i < size; ++i) {
      const int row = order[i];
      double value = gram(row, column) * scale[row] * scale[column];
      for (int j = 0; j < rank; ++j) value -= factor(i, j) * factor(rank, j);
      factor(i, rank) = value / diagonal;
      rest[row] -= factor(i, rank) * factor(i, rank);
    }
  }

  std::vector<double> y(rank);
  for (int i = 0; i < rank; ++i) {
    const auto row = static_cast<std::size_t>(order[i]);
    double value = scale[row] * right[row];
    for (int j = 0; j < i; ++j) value -= factor(i, j) * y[j];
    y[i] = value / factor(i, i);
  }
  std::vector<double> result(n, 0.0);
  for (int i = rank - 1; i >= 0; --i) {
    double value = y[i];
    for (int j = i + 1; j < rank; ++j) value -= factor(j, i) * y[j];
    y[i] = value / factor(i, i);
    const auto row = static_cast<std::size_t>(order[i]);
    result[row] = scale[row] * y[i];
  }
  return result;
}

}  // namespace harmos::latin
