#include <harmos/laws/detail/KarhunenLoeve.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::laws {

namespace {

// Of the variance: what the low rank leaves out; and the rank at which it stops anyway.
constexpr double leftOut = 1e-6;
constexpr std::size_t largestRank = 1000;
// Of the largest: eigenvalues that are round-off.
constexpr double noise = 1e-12;

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// The eigenvalues in ascending order; the matrix becomes the eigenvectors.
std::vector<double> eigenvaluesOf(base::Matrix& matrix) {
  const int n = matrix.numRows();
  std::vector<double> values(index(n)), work(index(std::max(1, 34 * n)));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', n, matrix.values(), matrix.stride(), values.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  if (info != 0) throw base::Error("LAPACK dsyev failed with info = " + std::to_string(info));
  return values;
}

}  // namespace

KarhunenLoeve::KarhunenLoeve(std::vector<base::Vector3> places, const std::vector<double>& areas, Covariance covariance,
                             double length, int wanted)
    : places_(std::move(places)), covariance_(covariance), length_(length), areas_(areas) {
  const std::size_t n = places_.size();
  std::vector<double> root(n), rest(n);
  for (std::size_t i = 0; i < n; ++i) {
    root[i] = std::sqrt(areas[i]);
    rest[i] = areas[i];
    area_ += areas[i];
  }
  // sqrt(h_i) C_ij sqrt(h_j) = L L^T + a rest, column by column of L.
  std::vector<std::vector<double>> columns;
  double left = area_;
  while (left > leftOut * area_ && columns.size() < std::min(n, largestRank)) {
    const auto pivot = static_cast<std::size_t>(std::max_element(rest.begin(), rest.end()) - rest.begin());
    const double scale = 1.0 / std::sqrt(rest[pivot]);
    std::vector<double> column(n);
    for (std::size_t i = 0; i < n; ++i) column[i] = root[i] * correlation(places_[i], places_[pivot]) * root[pivot];
    for (const std::vector<double>& before : columns) {
      for (std::size_t i = 0; i < n; ++i) column[i] -= before[i] * before[pivot];
    }
    left = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      column[i] *= scale;
      rest[i] = i == pivot ? 0.0 : std::max(0.0, rest[i] - column[i] * column[i]);
      left += rest[i];
    }
    columns.push_back(std::move(column));
  }
  const int rank = static_cast<int>(columns.size());
  base::Matrix gram(rank, rank);
  for (int a = 0; a < rank; ++a) {
    for (int b = a; b < rank; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i) sum += columns[index(a)][i] * columns[index(b)][i];
      gram(a, b) = gram(b, a) = sum;
    }
  }
  const std::vector<double> values = eigenvaluesOf(gram);
  for (int k = rank - 1; k >= 0 && values[index(k)] > noise * values.back(); --k)
    eigenvalues_.push_back(values[index(k)]);
  modes_.shape(static_cast<int>(n), std::min(wanted, terms()));
  for (int k = 0; k < modes_.numCols(); ++k) {
    const double* coefficients = gram[rank - 1 - k];
    double* mode = modes_[k];
    for (int a = 0; a < rank; ++a) {
      for (std::size_t i = 0; i < n; ++i) mode[i] += columns[index(a)][i] * coefficients[a];
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      mode[i] /= root[i];
      if (std::abs(mode[i]) > std::abs(largest)) largest = mode[i];
    }
    // Either sign is right; the same one on every machine.
    if (largest < 0.0) {
      for (std::size_t i = 0; i < n; ++i) mode[i] = -mode[i];
    }
  }
}

double KarhunenLoeve::correlation(const base::Vector3& a, const base::Vector3& b) const {
  const double ratio = distance(a, b) / length_;
  return std::exp(covariance_ == Covariance::exponential ? -ratio : -ratio * ratio);
}

double KarhunenLoeve::share(int count) const {
  double sum = 0.0;
  for (int k = 0; k < std::min(count, terms()); ++k) sum += eigenvalues_[index(k)];
  return std::min(1.0, sum / area_);
}

std::vector<double> KarhunenLoeve::atPoint(int point) const {
  std::vector<double> values;
  for (int k = 0; k < modes_.numCols(); ++k) values.push_back(modes_(point, k));
  return values;
}

std::vector<double> KarhunenLoeve::at(const base::Vector3& place) const {
  std::vector<double> values(index(modes_.numCols()), 0.0);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double weight = areas_[i] * correlation(place, places_[i]);
    for (int k = 0; k < modes_.numCols(); ++k) values[index(k)] += weight * modes_(static_cast<int>(i), k);
  }
  for (int k = 0; k < modes_.numCols(); ++k) values[index(k)] /= eigenvalues_[index(k)];
  return values;
}

}  // namespace harmos::laws
