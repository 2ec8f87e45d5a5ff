#include <harmos/substructure/SingleFactor.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_BLAS.hpp>

// BLAS, which Teuchos wraps but for this routine.
extern "C" void strsv_(const char* uplo, const char* transposed, const char* diagonal, const int* n, const float* a,
                       const int* stride, float* x, const int* increment);

namespace harmos::substructure {
namespace {

using Blas = Teuchos::BLAS<int, float>;

/// Right-hand sides and solutions in the order of L, column after column.
struct Block {
  int rows;
  int columns;
  std::vector<float> value;

  bool isZero(int first, int width) const {
    for (int j = 0; j < columns; ++j) {
      const float* begin = value.data() + static_cast<std::size_t>(j) * rows + first;
      if (std::any_of(begin, begin + width, [](float v) { return v != 0.0F; })) return false;
    }
    return true;
  }
};

/// Solves with the triangle of a supernode, or with its transpose, in place.
void solveTriangle(const Blas& blas, Teuchos::ETransp transposed, int width, const float* values, int height, float* x,
                   const Block& block) {
  if (block.columns == 1) {
    // One column is bound by memory, and strsm reads the triangle several times.
    constexpr int increment = 1;
    strsv_("L", transposed == Teuchos::TRANS ? "T" : "N", "N", &width, values, &height, x, &increment);
    return;
  }
  blas.TRSM(Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, transposed, Teuchos::NON_UNIT_DIAG, width, block.columns, 1.0F,
            values, height, x, block.rows);
}

/// y = scale op(A) x + keep y for the rows of a supernode below its triangle.
void multiply(const Blas& blas, Teuchos::ETransp transposed, int rows, int columns, float scale, const float* values,
              int height, const float* x, int strideX, float keep, float* y, int strideY, int count) {
  if (count == 1) {
    blas.GEMV(transposed, rows, columns, scale, values, height, x, 1, keep, y, 1);
    return;
  }
  const bool isTransposed = transposed == Teuchos::TRANS;
  blas.GEMM(transposed, Teuchos::NO_TRANS, isTransposed ? columns : rows, count, isTransposed ? rows : columns, scale,
            values, height, x, strideX, keep, y, strideY);
}

}  // namespace

void SingleFactor::solve(const base::Matrix& b, base::Matrix& x) const {
  const Blas blas;
  const auto supernodes = static_cast<int>(firstColumn.size()) - 1;
  Block y{static_cast<int>(order.size()), b.numCols(), {}};
  y.value.resize(order.size() * static_cast<std::size_t>(y.columns));
  std::vector<double> size(static_cast<std::size_t>(y.columns), 0.0);
  for (int j = 0; j < y.columns; ++j) {
    for (int k = 0; k < y.rows; ++k) size[j] = std::max(size[j], std::abs(b[j][k]));
    if (size[j] == 0.0) continue;
    float* to = y.value.data() + order.size() * static_cast<std::size_t>(j);
    for (int k = 0; k < y.rows; ++k) to[k] = static_cast<float>(b[j][order[k]] / size[j]);
  }
  std::vector<float> below(y.value.size());
  for (int s = 0; s < supernodes; ++s) {
    const int width = firstColumn[s + 1] - firstColumn[s], height = firstRow[s + 1] - firstRow[s];
    if (y.isZero(firstColumn[s], width)) continue;
    float* own = y.value.data() + firstColumn[s];
    const float* values = value.data() + firstValue[s];
    solveTriangle(blas, Teuchos::NO_TRANS, width, values, height, own, y);
    const int rest = height - width;
    if (rest == 0) continue;
    multiply(blas, Teuchos::NO_TRANS, rest, width, 1.0F, values + width, height, own, y.rows, 0.0F, below.data(), rest,
             y.columns);
    const int* rows = row.data() + firstRow[s] + width;
    for (int j = 0; j < y.columns; ++j) {
      float* to = y.value.data() + order.size() * static_cast<std::size_t>(j);
      const float* from = below.data() + static_cast<std::size_t>(rest) * j;
      for (int i = 0; i < rest; ++i) to[rows[i]] -= from[i];
    }
  }
  for (int s = supernodes - 1; s >= 0; --s) {
    const int width = firstColumn[s + 1] - firstColumn[s], height = firstRow[s + 1] - firstRow[s];
    float* own = y.value.data() + firstColumn[s];
    const float* values = value.data() + firstValue[s];
    const int rest = height - width;
    const int* rows = row.data() + firstRow[s] + width;
    for (int j = 0; j < y.columns && rest > 0; ++j) {
      const float* from = y.value.data() + order.size() * static_cast<std::size_t>(j);
      float* to = below.data() + static_cast<std::size_t>(rest) * j;
      for (int i = 0; i < rest; ++i) to[i] = from[rows[i]];
    }
    if (rest > 0) {
      multiply(blas, Teuchos::TRANS, rest, width, -1.0F, values + width, height, below.data(), rest, 1.0F, own, y.rows,
               y.columns);
    }
    solveTriangle(blas, Teuchos::TRANS, width, values, height, own, y);
  }
  for (int j = 0; j < y.columns; ++j) {
    const float* from = y.value.data() + order.size() * static_cast<std::size_t>(j);
    for (int k = 0; k < y.rows; ++k) x[j][order[k]] = size[j] * from[k];
  }
}

std::size_t SingleFactor::memory() const {
  return sizeof(float) * value.size() + sizeof(std::size_t) * firstValue.size() +
         sizeof(int) * (order.size() + firstColumn.size() + firstRow.size() + row.size());
}

}  // namespace harmos::substructure
