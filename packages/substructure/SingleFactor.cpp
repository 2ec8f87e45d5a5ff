#include <harmos/substructure/SingleFactor.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_CommHelpers.hpp>
#include <Teuchos_LAPACK.hpp>

namespace harmos::substructure {
namespace {

using Blas = Teuchos::BLAS<int, float>;

// Up to so many columns, products with one at a time are faster: a panel stays in the cache from one to the next, and
// products of matrices are made for many columns.
constexpr int fewColumns = 4;
// Columns of a panel: of wider ones more of the triangle is zero, more panels have more rows to gather.
constexpr int widest = 64;

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

// Bytes are counted by int on the way.
constexpr std::size_t bytesAtOnce = std::size_t{1} << 30;

/// Calls transfer(first, count) for slices of so many objects of a type that cover all of them.
template <class T, class Transfer>
void inSlices(std::size_t count, const Transfer& transfer) {
  constexpr std::size_t most = bytesAtOnce / sizeof(T);
  for (std::size_t first = 0; first < count; first += most)
    transfer(first, static_cast<int>(std::min(most, count - first)));
}

template <class T>
void sendAll(const Teuchos::Comm<int>& comm, int rank, const std::vector<T>& values) {
  inSlices<T>(values.size(), [&](std::size_t first, int count) {
    Teuchos::send(comm, count * static_cast<int>(sizeof(T)), reinterpret_cast<const char*>(values.data() + first),
                  rank);
  });
}

template <class T>
void receiveAll(const Teuchos::Comm<int>& comm, int rank, std::vector<T>& values) {
  inSlices<T>(values.size(), [&](std::size_t first, int count) {
    Teuchos::receive(comm, rank, count * static_cast<int>(sizeof(T)), reinterpret_cast<char*>(values.data() + first));
  });
}

}  // namespace

SingleFactor::SingleFactor(const std::vector<int>& order, std::size_t entries) : place_(order.size()) {
  for (std::size_t k = 0; k < order.size(); ++k) place_[order[k]] = static_cast<int>(k);
  values_.reserve(entries);
}

void SingleFactor::add(int columns, int height, const int* rows, const double* values) {
  const Blas blas;
  const Teuchos::LAPACK<int, float> lapack;
  const int firstRow = static_cast<int>(rows_.size());
  tallest_ = std::max(tallest_, height);
  rows_.insert(rows_.end(), rows, rows + height);
  for (int first = 0; first < columns; first += widest) {
    const int width = std::min(widest, columns - first), tall = height - first;
    panels_.push_back({columns_ + first, width, firstRow + first, tall, values_.size(), true});
    values_.resize(values_.size() + static_cast<std::size_t>(width) * tall, 0.0F);
    float* const panel = values_.data() + panels_.back().firstValue;
    for (int j = 0; j < width; ++j) {
      const double* const column = values + static_cast<std::size_t>(first + j) * height + first;
      std::copy(column + j, column + tall, panel + static_cast<std::size_t>(j) * tall + j);
    }
    int info = 0;
    lapack.TRTRI('L', 'N', width, panel, tall, &info);
    if (tall == width) continue;
    blas.TRMM(Teuchos::RIGHT_SIDE, Teuchos::LOWER_TRI, Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG, tall - width, width,
              1.0F, panel, tall, panel + width, tall);
  }
  columns_ += columns;
}

void SingleFactor::setTrace(const std::vector<int>& rows) {
  std::vector<int> panelOf(place_.size());
  trace_.clear();
  for (const int row : rows) trace_.push_back(place_[row]);
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    panels_[p].isOfTrace = false;
    std::fill_n(panelOf.begin() + panels_[p].firstColumn, panels_[p].width, static_cast<int>(p));
  }
  for (const int row : trace_) panels_[panelOf[row]].isOfTrace = true;
  // All rows below a panel are of panels that the next of them leads to.
  for (const Panel& panel : panels_) {
    if (panel.isOfTrace && panel.height > panel.width)
      panels_[panelOf[rows_[panel.firstRow + panel.width]]].isOfTrace = true;
  }
}

std::size_t SingleFactor::traceEntries() const {
  std::size_t sum = 0;
  for (const Panel& panel : panels_) {
    if (panel.isOfTrace) sum += static_cast<std::size_t>(panel.width) * panel.height;
  }
  return sum;
}

void SingleFactor::solve(const base::Matrix& b, base::Matrix& x, bool isOfTrace) const {
  const Blas blas;
  const int columns = b.numCols();
  const std::vector<int>& place = isOfTrace ? trace_ : place_;
  const std::size_t rows = place_.size(), given = place.size();
  // In the order of L, column after column.
  std::vector<float> y(rows * static_cast<std::size_t>(columns));
  std::vector<double> size(static_cast<std::size_t>(columns), 0.0);
  for (int j = 0; j < columns; ++j) {
    for (std::size_t k = 0; k < given; ++k) size[j] = std::max(size[j], std::abs(b[j][k]));
    if (size[j] == 0.0) continue;
    float* to = y.data() + rows * static_cast<std::size_t>(j);
    for (std::size_t i = 0; i < given; ++i) to[place[i]] = static_cast<float>(b[j][i] / size[j]);
  }
  std::vector<float> own(static_cast<std::size_t>(columns) * widest),
      whole(static_cast<std::size_t>(columns) * tallest_);
  for (const Panel& panel : panels_) {
    if (isOfTrace && !panel.isOfTrace) continue;
    const int width = panel.width, height = panel.height;
    bool isZero = true;
    for (int j = 0; j < columns; ++j) {
      const float* from = y.data() + rows * static_cast<std::size_t>(j) + panel.firstColumn;
      std::copy_n(from, width, own.data() + static_cast<std::size_t>(j) * width);
      isZero = isZero && std::all_of(from, from + width, [](float v) { return v == 0.0F; });
    }
    if (isZero) continue;
    multiply(blas, Teuchos::NO_TRANS, height, width, values_.data() + panel.firstValue, own.data(), whole.data(),
             columns);
    const int* below = rows_.data() + panel.firstRow;
    for (int j = 0; j < columns; ++j) {
      float* to = y.data() + rows * static_cast<std::size_t>(j);
      const float* from = whole.data() + static_cast<std::size_t>(height) * j;
      std::copy_n(from, width, to + panel.firstColumn);
      for (int i = width; i < height; ++i) to[below[i]] -= from[i];
    }
  }
  for (auto at = panels_.rbegin(); at != panels_.rend(); ++at) {
    const Panel& panel = *at;
    if (isOfTrace && !panel.isOfTrace) continue;
    const int width = panel.width, height = panel.height;
    const int* below = rows_.data() + panel.firstRow;
    for (int j = 0; j < columns; ++j) {
      const float* from = y.data() + rows * static_cast<std::size_t>(j);
      float* to = whole.data() + static_cast<std::size_t>(height) * j;
      std::copy_n(from + panel.firstColumn, width, to);
      for (int i = width; i < height; ++i) to[i] = -from[below[i]];
    }
    multiply(blas, Teuchos::TRANS, height, width, values_.data() + panel.firstValue, whole.data(), own.data(), columns);
    for (int j = 0; j < columns; ++j) {
      std::copy_n(own.data() + static_cast<std::size_t>(j) * width, width,
                  y.data() + rows * static_cast<std::size_t>(j) + panel.firstColumn);
    }
  }
  for (int j = 0; j < columns; ++j) {
    const float* from = y.data() + rows * static_cast<std::size_t>(j);
    for (std::size_t i = 0; i < given; ++i) x[j][i] = size[j] * from[place[i]];
  }
}

void SingleFactor::send(const Teuchos::Comm<int>& comm, int rank) const {
  const std::vector<std::size_t> sizes{place_.size(), panels_.size(), rows_.size(), values_.size(), trace_.size()};
  sendAll(comm, rank, sizes);
  sendAll(comm, rank, std::vector<int>{columns_, tallest_});
  sendAll(comm, rank, place_);
  sendAll(comm, rank, panels_);
  sendAll(comm, rank, rows_);
  sendAll(comm, rank, values_);
  sendAll(comm, rank, trace_);
}

SingleFactor SingleFactor::receive(const Teuchos::Comm<int>& comm, int rank) {
  static_assert(std::is_trivially_copyable_v<Panel>, "panels travel as bytes");
  std::vector<std::size_t> sizes(5);
  std::vector<int> numbers(2);
  receiveAll(comm, rank, sizes);
  receiveAll(comm, rank, numbers);
  SingleFactor factor({}, 0);
  factor.place_.resize(sizes[0]);
  factor.columns_ = numbers[0];
  factor.tallest_ = numbers[1];
  factor.panels_.resize(sizes[1]);
  factor.rows_.resize(sizes[2]);
  factor.values_.resize(sizes[3]);
  factor.trace_.resize(sizes[4]);
  receiveAll(comm, rank, factor.place_);
  receiveAll(comm, rank, factor.panels_);
  receiveAll(comm, rank, factor.rows_);
  receiveAll(comm, rank, factor.values_);
  receiveAll(comm, rank, factor.trace_);
  return factor;
}

std::size_t SingleFactor::memory() const {
  return sizeof(float) * values_.size() + sizeof(Panel) * panels_.size() +
         sizeof(int) * (place_.size() + rows_.size() + trace_.size());
}

}  // namespace harmos::substructure
