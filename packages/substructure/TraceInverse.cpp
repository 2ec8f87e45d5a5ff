#include <harmos/substructure/TraceInverse.hpp>

#include <algorithm>
#include <utility>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::substructure {
namespace {

/// (L L^T)^-1, both triangles.
base::Matrix inverseOf(const LowerTriangle& lower) {
  const int rows = lower.rows();
  base::Matrix inverse(rows, rows);
  for (int j = 0; j < rows; ++j) {
    for (int i = j; i < rows; ++i) inverse(i, j) = lower(i, j);
  }
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRI('L', rows, inverse.values(), inverse.stride(), &info);
  if (info != 0) throw base::Error("A trace is singular.");
  for (int j = 0; j < rows; ++j) {
    for (int i = j; i < rows; ++i) inverse(j, i) = inverse(i, j);
  }
  return inverse;
}

std::vector<MirrorPlanes::Row> permuted(const std::vector<MirrorPlanes::Row>& rows, const std::vector<int>& order) {
  std::vector<MirrorPlanes::Row> result;
  for (std::size_t j = 0; !rows.empty() && j < order.size(); ++j) result.push_back(rows[order[j]]);
  return result;
}

/// T S T.
void changeBothWays(const MirrorPlanes& planes, base::Matrix& matrix) {
  for (int pass = 0; planes.count() > 0 && pass < 2; ++pass) {
    planes.change(matrix);
    for (int j = 0; j < matrix.numCols(); ++j) {
      for (int i = 0; i < j; ++i) std::swap(matrix(i, j), matrix(j, i));
    }
  }
}

}  // namespace

TraceInverse::TraceInverse(const TraceFactor& factor, const std::vector<MirrorPlanes::Row>& rows)
    : order_(factor.order), planes_({}, base::Matrix()) {
  base::Matrix inverse = inverseOf(factor.lower);
  planes_ = MirrorPlanes(permuted(rows, order_), inverse);
  changeBothWays(planes_, inverse);
  for (std::vector<int>& some : planes_.blocks()) {
    const int count = static_cast<int>(some.size());
    Block block{std::move(some), SymmetricTriangle<double>(count), SymmetricTriangle<float>(count)};
    for (int j = 0; j < count; ++j) {
      for (int i = j; i < count; ++i) {
        const double entry = inverse(block.rows[i], block.rows[j]);
        block.exact.set(i, j, entry);
        block.rough.set(i, j, entry);
      }
    }
    blocks_.push_back(std::move(block));
  }
}

std::size_t TraceInverse::entries() const {
  std::size_t sum = 0;
  for (const Block& block : blocks_) sum += block.exact.entries();
  return sum;
}

template <class Multiply>
void TraceInverse::apply(const base::Matrix& b, base::Matrix& x, const Multiply& multiply) const {
  const int columns = b.numCols();
  base::Matrix changed(rows(), columns, false), part, product;
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows(); ++row) changed[j][row] = b[j][order_[row]];
  }
  planes_.change(changed);
  for (const Block& block : blocks_) {
    const int count = static_cast<int>(block.rows.size());
    part.shapeUninitialized(count, columns);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < count; ++i) part[j][i] = changed[j][block.rows[i]];
    }
    multiply(block, part, product);
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < count; ++i) changed[j][block.rows[i]] = product[j][i];
    }
  }
  planes_.change(changed);
  if (x.numRows() != rows() || x.numCols() != columns) x.shapeUninitialized(rows(), columns);
  for (int j = 0; j < columns; ++j) {
    for (int row = 0; row < rows(); ++row) x[j][order_[row]] = changed[j][row];
  }
}

void TraceInverse::solve(const base::Matrix& b, base::Matrix& x) const {
  apply(b, x, [](const Block& block, const base::Matrix& from, base::Matrix& to) { block.exact.multiply(from, to); });
}

void TraceInverse::solveRoughly(const base::Matrix& b, base::Matrix& x) const {
  apply(b, x, [](const Block& block, const base::Matrix& from, base::Matrix& to) { block.rough.multiply(from, to); });
}

}  // namespace harmos::substructure
