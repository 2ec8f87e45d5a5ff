#include <harmos/latin/NormalEquations.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

namespace harmos::latin {
namespace {

// Columns that meet as many others at once, so that each number that is loaded is multiplied as often; and rows that
// the caches hold of all columns.
constexpr int tile = 3;
constexpr int rowsAtOnce = 256;

typedef double Two __attribute__((vector_size(16)));

Two load(const double* from) {
  Two result;
  std::memcpy(&result, from, sizeof result);
  return result;
}

/// Columns from number `first` on, and the last one again beyond it; each from a row on.
std::array<const double*, tile> columnsFrom(const base::Matrix& columns, int first, int row) {
  std::array<const double*, tile> result;
  for (int i = 0; i < tile; ++i) result[i] = columns[std::min(first + i, columns.numCols() - 1)] + row;
  return result;
}

void addProducts(const std::array<const double*, tile>& a, const std::array<const double*, tile>& b, int rows,
                 std::array<double, tile * tile>& sums) {
  const auto [a0, a1, a2] = a;
  const auto [b0, b1, b2] = b;
  Two s[tile * tile] = {};
  int row = 0;
  for (; row + 1 < rows; row += 2) {
    const Two x0 = load(a0 + row), x1 = load(a1 + row), x2 = load(a2 + row);
    const Two y0 = load(b0 + row), y1 = load(b1 + row), y2 = load(b2 + row);
    s[0] += x0 * y0;
    s[1] += x0 * y1;
    s[2] += x0 * y2;
    s[3] += x1 * y0;
    s[4] += x1 * y1;
    s[5] += x1 * y2;
    s[6] += x2 * y0;
    s[7] += x2 * y1;
    s[8] += x2 * y2;
  }
  for (int i = 0; i < tile * tile; ++i) {
    sums[i] += s[i][0] + s[i][1];
    if (row < rows) sums[i] += a[i / tile][row] * b[i % tile][row];
  }
}

}  // namespace

base::Matrix gramMatrix(const base::Matrix& columns) {
  const int count = columns.numCols();
  base::Matrix gram(count, count);
  for (int row = 0; row < columns.numRows(); row += rowsAtOnce) {
    const int rows = std::min(rowsAtOnce, columns.numRows() - row);
    for (int p = 0; p < count; p += tile) {
      for (int q = 0; q <= p; q += tile) {
        std::array<double, tile * tile> sums{};
        addProducts(columnsFrom(columns, p, row), columnsFrom(columns, q, row), rows, sums);
        for (int i = 0; i < tile * tile; ++i) {
          const int a = p + i / tile, b = q + i % tile;
          if (a < count && b <= a) gram(a, b) += sums[i];
        }
      }
    }
  }
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b < a; ++b) gram(b, a) = gram(a, b);
  }
  return gram;
}

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
