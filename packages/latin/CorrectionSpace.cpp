#include <harmos/latin/CorrectionSpace.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

// By divide and conquer, faster where directions are many than GELSS, which Teuchos has.
extern "C" void dgelsd_(const int* m, const int* n, const int* nrhs, double* a, const int* lda, double* b,
                        const int* ldb, double* s, const double* rcond, int* rank, double* work, const int* lwork,
                        int* iwork, int* info);

namespace harmos::latin {
namespace {

// Share of a residual outside of the space below which it is round-off.
constexpr double roundOff = 1e-9;
// Singular values below this share of the largest one are those of round-off. I - J has none above 2 where loads are
// given; where they are found (PathControl) single ones are many times as large, and in single precision, whose share
// of them would hide others, 2 stands for them. With images in double precision smaller ones are those of soft springs.
constexpr double singularInSingle = 1e-7;
constexpr double singularInDouble = 1e-10;
constexpr double ordinary = 2.0;
// Of least squares that are damped: some thousand times what images in double precision resolve.
constexpr double damping = 2e-7;
// Of new columns of Q: more are orthonormalised among themselves, by products with vectors, than matrices gain.
constexpr int columnsAtOnce = 32;
// Of the columns, for which there is room from the first one on: what is copied when they grow takes new memory.
constexpr int leastRoom = 4;

base::Matrix dense(const std::vector<std::vector<double>>& triangle, int size) {
  base::Matrix matrix(size, size);
  for (int j = 0; j < size; ++j) std::copy_n(triangle[j].begin(), j + 1, matrix[j]);
  return matrix;
}

/// Of a triangle by columns, in descending order.
std::vector<double> singularValues(const std::vector<std::vector<double>>& triangle, int size) {
  base::Matrix matrix = dense(triangle, size);
  std::vector<double> values(size), work(static_cast<std::size_t>(64 * (size + 1)));
  double unused = 0.0;
  int info = 0;
  Teuchos::LAPACK<int, double>().GESVD('N', 'N', size, size, matrix.values(), matrix.stride(), values.data(), &unused,
                                       1, &unused, 1, work.data(), static_cast<int>(work.size()), &unused, &info);
  return values;
}

/// y = kept y + factor B x, or of B^T, for columns of x. A matrix of one column takes GEMM longer than GEMV.
void multiply(Teuchos::ETransp transposed, const double* b, int rows, int count, double factor, const double* x,
              int columns, double kept, double* y) {
  const Teuchos::BLAS<int, double> blas;
  const bool isTransposed = transposed == Teuchos::TRANS;
  const int inner = isTransposed ? rows : count, outer = isTransposed ? count : rows;
  if (columns == 1) {
    blas.GEMV(transposed, rows, count, factor, b, rows, x, 1, kept, y, 1);
  } else {
    blas.GEMM(transposed, Teuchos::NO_TRANS, outer, columns, inner, factor, b, rows, x, inner, kept, y, outer);
  }
}

/// The shortest x with the least |matrix x - b|, where singular values below `least` of the largest count as none;
/// destroys the matrix.
void solveWithoutSmall(base::Matrix& matrix, std::vector<double>& b, double least) {
  const int size = matrix.numRows(), stride = matrix.stride(), one = 1, ask = -1;
  std::vector<double> values(b.size());
  double wanted = 0.0;
  int rank = 0, info = 0, wantedIntegers = 0;
  dgelsd_(&size, &size, &one, matrix.values(), &stride, b.data(), &size, values.data(), &least, &rank, &wanted, &ask,
          &wantedIntegers, &info);
  const int room = static_cast<int>(wanted);
  std::vector<double> work(static_cast<std::size_t>(room));
  std::vector<int> integers(static_cast<std::size_t>(std::max(1, wantedIntegers)));
  dgelsd_(&size, &size, &one, matrix.values(), &stride, b.data(), &size, values.data(), &least, &rank, work.data(),
          &room, integers.data(), &info);
  if (info != 0) std::fill(b.begin(), b.end(), 0.0);  // of what is no number: no step
}

}  // namespace

CorrectionSpace::CorrectionSpace(const StateMetric& metric, substructure::Precision images)
    : metric_(&metric), singular_(images == substructure::Precision::single ? singularInSingle : singularInDouble) {}

double CorrectionSpace::negligibleShare(const std::vector<double>& values) const {
  return singular_ == singularInDouble ? singular_ : singular_ * std::min(1.0, ordinary / values.front());
}

std::vector<double> CorrectionSpace::scaled(const double* x) const {
  std::vector<double> result(metric_->scale());
  for (std::size_t row = 0; row < result.size(); ++row) result[row] *= x[row];
  return result;
}

double CorrectionSpace::norm(const double* scaled) const {
  std::vector<double> sum{std::inner_product(scaled, scaled + rows(), scaled, 0.0)};
  metric_->sum(sum);
  return std::sqrt(sum[0]);
}

std::vector<double> CorrectionSpace::project(int first, int count, double* x, int columns) const {
  std::vector<double> products(static_cast<std::size_t>(count) * static_cast<std::size_t>(columns), 0.0);
  if (count == 0) return products;
  const double* basis = orthonormal_.data() + at(first);
  multiply(Teuchos::TRANS, basis, rows(), count, 1.0, x, columns, 0.0, products.data());
  metric_->sum(products);
  multiply(Teuchos::NO_TRANS, basis, rows(), count, -1.0, products.data(), columns, 1.0, x);
  return products;
}

std::vector<double> CorrectionSpace::projectTwice(int first, int count, double* x) const {
  std::vector<double> products = project(first, count, x, 1);
  const std::vector<double> again = project(first, count, x, 1);
  for (int i = 0; i < count; ++i) products[i] += again[i];
  return products;
}

base::Matrix CorrectionSpace::orthonormalise(int first, int count) {
  base::Matrix triangle(count, count);
  for (int j = 0; j < count; ++j) {
    double* x = orthonormal_.data() + at(first + j);
    const std::vector<double> products = projectTwice(first, j, x);
    std::copy(products.begin(), products.end(), triangle[j]);
    const double length = norm(x);
    triangle[j][j] = length;
    if (length > 0.0) std::for_each(x, x + rows(), [length](double& value) { value /= length; });
  }
  return triangle;
}

std::vector<double> CorrectionSpace::coefficients(const double* v) const {
  std::vector<double> products(size_);
  if (size_ == 0) return products;
  const Teuchos::BLAS<int, double> blas;
  std::vector<double> x = scaled(v);
  x = scaled(x.data());
  blas.GEMV(Teuchos::TRANS, rows(), size_, 1.0, directions_.data(), rows(), x.data(), 1, 0.0, products.data(), 1);
  metric_->sum(products);
  return products;
}

bool CorrectionSpace::makeIndependent(double* v) const {
  const Teuchos::BLAS<int, double> blas;
  const double before = norm(scaled(v).data());
  for (int pass = 0; pass < 2 && size_ > 0; ++pass) {
    const std::vector<double> products = coefficients(v);
    blas.GEMV(Teuchos::NO_TRANS, rows(), size_, -1.0, directions_.data(), rows(), products.data(), 1, 1.0, v, 1);
  }
  const double length = norm(scaled(v).data());
  if (!(length > roundOff * before)) return false;
  blas.SCAL(rows(), 1.0 / length, v, 1);
  return true;
}

void CorrectionSpace::makeRoom(std::vector<double>& columns, int count) const {
  const std::size_t wanted = columns.size() + at(count);
  if (columns.capacity() < wanted)
    columns.reserve(std::max({wanted, columns.size() + columns.size() / 2, at(leastRoom)}));
}

void CorrectionSpace::add(const double* v, const double* y) {
  for (std::vector<double>* columns : {&directions_, &images_}) makeRoom(*columns, 1);
  directions_.insert(directions_.end(), v, v + rows());
  images_.insert(images_.end(), y, y + rows());
  ++size_;
}

void CorrectionSpace::add(const double* v) {
  for (std::vector<double>* columns : {&directions_, &images_}) makeRoom(*columns, 1);
  directions_.insert(directions_.end(), v, v + rows());
  images_.resize(directions_.size(), 0.0);
  ++size_;
}

void CorrectionSpace::setImage(int direction, const double* y) {
  std::copy_n(y, rows(), images_.begin() + static_cast<std::ptrdiff_t>(at(direction)));
}

void CorrectionSpace::append(const base::Matrix& g) {
  assert(known_ + g.numCols() <= size_ && "all directions have their g");
  for (int first = 0; first < g.numCols(); first += columnsAtOnce) {
    appendTogether(g, first, std::min(columnsAtOnce, g.numCols() - first));
  }
}

void CorrectionSpace::appendTogether(const base::Matrix& g, int first, int count) {
  orthonormal_.resize(at(known_));
  makeRoom(orthonormal_, count);
  for (int j = first; j < first + count; ++j) {
    const std::vector<double> x = scaled(g[j]);
    orthonormal_.insert(orthonormal_.end(), x.begin(), x.end());
  }
  // Twice, since what the first pass leaves of a column that Q nearly holds is no longer orthogonal to Q.
  double* columns = orthonormal_.data() + at(known_);
  const std::vector<double> inBasis = project(0, known_, columns, count);
  const base::Matrix among = orthonormalise(known_, count);
  const std::vector<double> inBasisAgain = project(0, known_, columns, count);
  const base::Matrix amongAgain = orthonormalise(known_, count);
  triangle_.resize(known_);
  for (int j = 0; j < count; ++j) {
    std::vector<double> column(inBasis.begin() + static_cast<std::ptrdiff_t>(j) * known_,
                               inBasis.begin() + static_cast<std::ptrdiff_t>(j + 1) * known_);
    column.resize(static_cast<std::size_t>(known_) + j + 1);
    for (int k = 0; k <= j; ++k) {
      for (int i = 0; i < known_; ++i)
        column[i] += inBasisAgain[static_cast<std::size_t>(k) * known_ + i] * among[j][k];
      for (int i = 0; i <= k; ++i) column[known_ + i] += amongAgain[k][i] * among[j][k];
    }
    triangle_.push_back(std::move(column));
  }
  known_ += count;
  hasSingularValues_ = false;
}

void CorrectionSpace::findSingularValues() const {
  if (hasSingularValues_) return;
  const std::vector<double> values = singularValues(triangle_, known_);
  negligible_ = negligibleShare(values);
  const double least = negligible_ * values.front();
  isSingular_ = values.back() <= least;
  const auto last = std::find_if(values.rbegin(), values.rend(), [&](double value) { return value > least; });
  smallest_ = last == values.rend() ? 0.0 : std::min(1.0, *last);
  hasSingularValues_ = true;
}

CorrectionSpace::LeastSquares CorrectionSpace::projected(const double* residual) const {
  assert(known_ == size_ && "a direction lacks its g");
  std::vector<double> x = scaled(residual);
  LeastSquares result;
  result.c = projectTwice(0, size_, x.data());
  result.left = norm(x.data());
  return result;
}

CorrectionSpace::LeastSquares CorrectionSpace::solve(const double* residual) const {
  LeastSquares result = projected(residual);
  if (size_ == 0) return result;
  base::Matrix matrix = dense(triangle_, size_);
  findSingularValues();
  if (!isSingular_) {
    int info = 0;
    Teuchos::LAPACK<int, double>().TRTRS('U', 'N', 'N', size_, 1, matrix.values(), matrix.stride(), result.c.data(),
                                         size_, &info);
    return result;
  }
  const std::vector<double> right = result.c;
  solveWithoutSmall(matrix, result.c, negligible_);
  result.left = std::hypot(result.left, leftInside(right, result.c));
  return result;
}

CorrectionSpace::LeastSquares CorrectionSpace::solveDamped(const double* residual) const {
  LeastSquares result = projected(residual);
  if (size_ == 0) return result;
  const std::vector<double> right = result.c;
  base::Matrix stacked(2 * size_, size_), b(2 * size_, 1);
  for (int j = 0; j < size_; ++j) {
    std::copy_n(triangle_[j].begin(), j + 1, stacked[j]);
    stacked[j][size_ + j] = damping;
  }
  std::copy(right.begin(), right.end(), b[0]);
  std::vector<double> work(static_cast<std::size_t>(64 * size_));
  int info = 0;
  Teuchos::LAPACK<int, double>().GELS('N', 2 * size_, size_, 1, stacked.values(), stacked.stride(), b.values(),
                                      b.stride(), work.data(), static_cast<int>(work.size()), &info);
  std::copy_n(b[0], size_, result.c.begin());
  result.left = std::hypot(result.left, leftInside(right, result.c));
  return result;
}

double CorrectionSpace::leftInside(const std::vector<double>& right, const std::vector<double>& c) const {
  double inside = 0.0;
  for (int i = 0; i < size_; ++i) {
    double rest = right[i];
    for (int j = i; j < size_; ++j) rest -= triangle_[j][i] * c[j];
    inside += rest * rest;
  }
  return std::sqrt(inside);
}

std::vector<double> CorrectionSpace::rest(const double* residual, const std::vector<double>& c) const {
  std::vector<double> inBasis(size_, 0.0), x = scaled(residual);
  for (int j = 0; j < size_; ++j) {
    for (int i = 0; i <= j; ++i) inBasis[i] += triangle_[j][i] * c[j];
  }
  if (size_ > 0) {
    Teuchos::BLAS<int, double>().GEMV(Teuchos::NO_TRANS, rows(), size_, -1.0, orthonormal_.data(), rows(),
                                      inBasis.data(), 1, 1.0, x.data(), 1);
  }
  for (std::size_t row = 0; row < x.size(); ++row) x[row] /= metric_->scale()[row];
  return x;
}

double CorrectionSpace::smallestSingularValue() const {
  if (known_ == 0) return 1.0;
  findSingularValues();
  return smallest_;
}

void CorrectionSpace::move(const std::vector<double>& c, double length, double* alpha, double* beta) const {
  if (size_ == 0) return;
  const Teuchos::BLAS<int, double> blas;
  blas.GEMV(Teuchos::NO_TRANS, rows(), size_, length, directions_.data(), rows(), c.data(), 1, 1.0, alpha, 1);
  blas.GEMV(Teuchos::NO_TRANS, rows(), size_, length, images_.data(), rows(), c.data(), 1, 1.0, beta, 1);
}

}  // namespace harmos::latin
