#include <harmos/substructure/SingleFactor.hpp>

#include <algorithm>
#include <cmath>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

namespace harmos::substructure {
namespace {

using Blas = Teuchos::BLAS<int, float>;

// Up to so many columns, products with one at a time are faster: a panel stays in the cache from one to the next, and
// products of matrices are made for many columns.
constexpr int fewColumns = 4;

/// y = op(A) x for a panel of so many rows and columns, and `count` vectors without gaps.
void multiply(const Blas& blas, Teuchos::ETransp transposed, int rows, int columns, const float* panel, const float* x,
              float* y, int count) {
  const bool isTransposed = transposed == Teuchos::TRANS;
  const int strideX = isTransposed ? rows : columns, strideY = isTransposed ? columns : rows;
  if (count <= fewColumns) {
    for (int j = 0; j < count; ++j, x += strideX, y += strideY)
      blas.GEMV(transposed, rows, columns, 1.0F, panel, rows, x, 1, 0.0F, y, 1);
    return;
  }
  blas.GEMM(transposed, Teuchos::NO_TRANS, strideY, count, strideX, 1.0F, panel, rows, x, strideX, 0.0F, y, strideY);
}

}  // namespace

void SingleFactor::invertTriangles() {
  const Blas blas;
  const Teuchos::LAPACK<int, float> lapack;
  for (std::size_t s = 0; s + 1 < firstColumn.size(); ++s) {
    const int width = firstColumn[s + 1] - firstColumn[s], height = firstRow[s + 1] - firstRow[s];
    float* panel = value.data() + firstValue[s];
    for (int j = 1; j < width; ++j) std::fill_n(panel + static_cast<std::size_t>(j) * height, j, 0.0F);
    int info = 0;
    lapack.TRTRI('L', 'N', width, panel, height, &info);
    if (height == width) continue;
    blas.TRMM(Teuchos::RIGHT_SIDE, Teuchos::LOWER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG, height - width, width,
              1.0F, panel, height, panel + width, height);
  }
}

void SingleFactor::solve(const base::Matrix& b, base::Matrix& x) const {
  const Blas blas;
  const auto supernodes = static_cast<int>(firstColumn.size()) - 1;
  const int columns = b.numCols();
  const std::size_t rows = order.size();
  // In the order of L, column after column.
  std::vector<float> y(rows * static_cast<std::size_t>(columns));
  std::vector<double> size(static_cast<std::size_t>(columns), 0.0);
  for (int j = 0; j < columns; ++j) {
    for (std::size_t k = 0; k < rows; ++k) size[j] = std::max(size[j], std::abs(b[j][k]));
    if (size[j] == 0.0) continue;
    float* to = y.data() + rows * static_cast<std::size_t>(j);
    for (std::size_t k = 0; k < rows; ++k) to[k] = static_cast<float>(b[j][order[k]] / size[j]);
  }
  std::vector<float> own(y.size()), whole(y.size());
  for (int s = 0; s < supernodes; ++s) {
    const int width = firstColumn[s + 1] - firstColumn[s], height = firstRow[s + 1] - firstRow[s];
    bool isZero = true;
    for (int j = 0; j < columns; ++j) {
      const float* from = y.data() + rows * static_cast<std::size_t>(j) + firstColumn[s];
      std::copy_n(from, width, own.data() + static_cast<std::size_t>(j) * width);
      isZero = isZero && std::all_of(from, from + width, [](float v) { return v == 0.0F; });
    }
    if (isZero) continue;
    multiply(blas, Teuchos::NO_TRANS, height, width, value.data() + firstValue[s], own.data(), whole.data(), columns);
    const int* below = row.data() + firstRow[s];
    for (int j = 0; j < columns; ++j) {
      float* to = y.data() + rows * static_cast<std::size_t>(j);
      const float* from = whole.data() + static_cast<std::size_t>(height) * j;
      std::copy_n(from, width, to + firstColumn[s]);
      for (int i = width; i < height; ++i) to[below[i]] -= from[i];
    }
  }
  for (int s = supernodes - 1; s >= 0; --s) {
    const int width = firstColumn[s + 1] - firstColumn[s], height = firstRow[s + 1] - firstRow[s];
    const int* below = row.data() + firstRow[s];
    for (int j = 0; j < columns; ++j) {
      const float* from = y.data() + rows * static_cast<std::size_t>(j);
      float* to = whole.data() + static_cast<std::size_t>(height) * j;
      std::copy_n(from + firstColumn[s], width, to);
      for (int i = width; i < height; ++i) to[i] = -from[below[i]];
    }
    multiply(blas, Teuchos::TRANS, height, width, value.data() + firstValue[s], whole.data(), own.data(), columns);
    for (int j = 0; j < columns; ++j) {
      std::copy_n(own.data() + static_cast<std::size_t>(j) * width, width,
                  y.data() + rows * static_cast<std::size_t>(j) + firstColumn[s]);
    }
  }
  for (int j = 0; j < columns; ++j) {
    const float* from = y.data() + rows * static_cast<std::size_t>(j);
    for (std::size_t k = 0; k < rows; ++k) x[j][order[k]] = size[j] * from[k];
  }
}

std::size_t SingleFactor::memory() const {
  return sizeof(float) * value.size() + sizeof(std::size_t) * firstValue.size() +
         sizeof(int) * (order.size() + firstColumn.size() + firstRow.size() + row.size());
}

}  // namespace harmos::substructure
