#include <harmos/design/Surrogate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/design/detail/Confidence.hpp>

namespace harmos::design {

namespace {

using Points = std::vector<std::vector<double>>;

constexpr double infinity = std::numeric_limits<double>::infinity();
// The likelihood of this many points tells the lengths; of more it takes long and tells the same.
constexpr std::size_t mostPointsForChoice = 200;
constexpr double leastNugget = 1e-10, largestNugget = 1e-1;  // below, correlations are singular
constexpr double nuggetGrowth = 10.0;                        // when they are singular still
constexpr double leastLength = 0.1, largestLength = 50.0, firstLength = 2.0;
// So that the polynomial does not follow what the process should.
constexpr std::size_t pointsPerTerm = 2;
// Of the search for lengths and nugget: the logarithm of a step, and what a better score gains at least.
const double firstStep = std::log(4.0);
constexpr double lastStep = 0.1, leastGain = 1e-3;
// Steps of the nugget over those of a length: it ranges over more decades.
constexpr double nuggetStep = 3.0;
// Distance beyond the box of the points that is round-off, over its half width.
constexpr double besideTheBox = 1e-9;

/// Solves L x = b (or L^T x = b) in place.
void solveTriangular(const base::Matrix& lower, bool isTransposed, base::Matrix& b) {
  Teuchos::BLAS<int, double>().TRSM(
      Teuchos::LEFT_SIDE, Teuchos::LOWER_TRI, isTransposed ? Teuchos::TRANS : Teuchos::NO_TRANS, Teuchos::NON_UNIT_DIAG,
      b.numRows(), b.numCols(), 1.0, lower.values(), lower.stride(), b.values(), b.stride());
}

bool factorCholesky(base::Matrix& matrix) {
  int info = 0;
  Teuchos::LAPACK<int, double>().POTRF('L', matrix.numRows(), matrix.values(), matrix.stride(), &info);
  return info == 0;
}

base::Matrix column(const std::vector<double>& values) {
  base::Matrix result(static_cast<int>(values.size()), 1);
  std::copy(values.begin(), values.end(), result.values());
  return result;
}

double dot(const double* a, const double* b, int count) {
  return std::inner_product(a, a + count, b, 0.0);
}

/// The element at this fraction of the sorted values.
double quantile(std::vector<double> values, double fraction) {
  const auto at = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size()))) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace

Surrogate::Surrogate(Points points, std::vector<double> values, double uncertainty) : values_(std::move(values)) {
  const auto isFinite = [](double value) { return std::isfinite(value); };
  if (points.size() < 3) throw base::Error("A response surface needs at least 3 solutions.");
  if (!std::all_of(values_.begin(), values_.end(), isFinite)) throw base::Error("A response is not a finite number.");
  const std::size_t parameters = points.front().size();
  for (std::size_t p = 0; p < parameters; ++p) {
    const auto [least, most] =
        std::minmax_element(points.begin(), points.end(), [p](const auto& a, const auto& b) { return a[p] < b[p]; });
    model_.lower.push_back((*least)[p]);
    model_.upper.push_back((*most)[p]);
  }
  for (const auto& point : points) points_.push_back(scaled(point));
  const std::size_t linear = parameters + 1, quadratic = (parameters + 1) * (parameters + 2) / 2;
  model_.degree = points.size() >= pointsPerTerm * quadratic ? 2 : points.size() >= pointsPerTerm * linear ? 1 : 0;
  model_.lengths.assign(parameters, firstLength);
  model_.nugget = leastNugget;
  chooseModel(uncertainty);
  while (!solve(points_, values_, system_)) {
    // All points together may be nearer to singular than those of the choice.
    model_.nugget *= nuggetGrowth;
    if (model_.nugget > largestNugget) throw base::Error("The response surface cannot be computed.");
  }
  calibrate();
}

std::vector<double> Surrogate::scaled(const std::vector<double>& point) const {
  std::vector<double> x(point.size());
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double width = model_.upper[p] - model_.lower[p];
    x[p] = width > 0.0 ? (2.0 * point[p] - model_.lower[p] - model_.upper[p]) / width : 0.0;
  }
  return x;
}

std::vector<double> Surrogate::monomials(const std::vector<double>& x) const {
  std::vector<double> f = {1.0};
  if (model_.degree >= 1) f.insert(f.end(), x.begin(), x.end());
  if (model_.degree >= 2) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      for (std::size_t j = i; j < x.size(); ++j) f.push_back(x[i] * x[j]);
    }
  }
  return f;
}

double Surrogate::correlation(const std::vector<double>& x, const std::vector<double>& y) const {
  double square = 0.0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double difference = (x[p] - y[p]) / model_.lengths[p];
    square += difference * difference;
  }
  const double distance = std::sqrt(5.0 * square);
  return (1.0 + distance + distance * distance / 3.0) * std::exp(-distance);
}

bool Surrogate::solve(const Points& points, const std::vector<double>& values, System& system) const {
  const int n = static_cast<int>(points.size());
  const int terms = static_cast<int>(monomials(points.front()).size());
  system.factor.shape(n, n);
  system.trend.shape(n, terms);
  for (int j = 0; j < n; ++j) {
    const auto& x = points[j];
    for (int i = j; i < n; ++i) system.factor(i, j) = correlation(points[i], x);
    system.factor(j, j) += model_.nugget;
    const auto f = monomials(x);
    for (int k = 0; k < terms; ++k) system.trend(j, k) = f[k];
  }
  if (!factorCholesky(system.factor)) return false;
  solveTriangular(system.factor, false, system.trend);
  base::Matrix rest = column(values);
  solveTriangular(system.factor, false, rest);

  // Normal equations are good enough: the monomials of scaled points are well conditioned.
  system.trendFactor.shape(terms, terms);
  system.trendFactor.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, system.trend, system.trend, 0.0);
  if (!factorCholesky(system.trendFactor)) return false;
  base::Matrix coefficients(terms, 1);
  coefficients.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, system.trend, rest, 0.0);
  solveTriangular(system.trendFactor, false, coefficients);
  solveTriangular(system.trendFactor, true, coefficients);
  rest.multiply(Teuchos::NO_TRANS, Teuchos::NO_TRANS, -1.0, system.trend, coefficients, 1.0);
  const double square = dot(rest.values(), rest.values(), n);
  system.variance = square / std::max(n - terms, 1);
  system.score = (n - terms) * std::log(std::max(system.variance, std::numeric_limits<double>::min()));
  for (int i = 0; i < n; ++i) system.score += 2.0 * std::log(system.factor(i, i));
  for (int i = 0; i < terms; ++i) system.score += 2.0 * std::log(system.trendFactor(i, i));
  solveTriangular(system.factor, true, rest);
  system.weights.assign(rest.values(), rest.values() + n);
  system.coefficients.assign(coefficients.values(), coefficients.values() + terms);
  return true;
}

/// Looks for the most likely lengths and nugget, one after the other, with steps that are halved.
void Surrogate::chooseModel(double uncertainty) {
  Points points;
  std::vector<double> values;
  const std::size_t count = std::min(points_.size(), mostPointsForChoice);
  for (std::size_t i = 0; i < count; ++i) {
    // Evenly through the list; a grid is hit at odd places because the stride is no whole number.
    const std::size_t at = i * points_.size() / count;
    points.push_back(points_[at]);
    values.push_back(values_[at]);
  }
  System system;
  const auto score = [&] {
    if (!solve(points, values, system)) return infinity;
    const bool smoothsTooMuch =
        model_.nugget > leastNugget && model_.nugget * system.variance > uncertainty * uncertainty;
    return smoothsTooMuch ? infinity : system.score;
  };
  double best = score();
  for (double step = firstStep; step > lastStep; step *= 0.5) {
    for (bool isBetter = true; isBetter;) {
      isBetter = false;
      for (std::size_t which = 0; which <= model_.lengths.size(); ++which) {
        const bool isNugget = which == model_.lengths.size();
        double& value = isNugget ? model_.nugget : model_.lengths[which];
        for (const double direction : {1.0, -1.0}) {
          const double before = value;
          value = std::clamp(before * std::exp((isNugget ? nuggetStep : 1.0) * direction * step),
                             isNugget ? leastNugget : leastLength, isNugget ? largestNugget : largestLength);
          const double tried = score();
          if (tried < best - leastGain) {
            best = tried;
            isBetter = true;
          } else {
            value = before;
          }
        }
      }
    }
  }
}

void Surrogate::calibrate() {
  // Of Q = C^-1 - C^-1 F (F^T C^-1 F)^-1 F^T C^-1 the diagonal tells the deviation of a point from the others'
  // prediction.
  const int n = static_cast<int>(points_.size());
  base::Matrix inverse(n, n);
  for (int i = 0; i < n; ++i) inverse(i, i) = 1.0;
  solveTriangular(system_.factor, false, inverse);
  base::Matrix trend(system_.trend.numCols(), n);
  trend.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, system_.trend, inverse, 0.0);
  solveTriangular(system_.trendFactor, false, trend);
  std::vector<double> ratios;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double q = dot(inverse[i], inverse[i], n) - dot(trend[i], trend[i], trend.numRows());
    const double error = std::abs(system_.weights[i]) / q;
    const double expected = std::sqrt(system_.variance / q);
    ratios.push_back(expected > 0.0 ? error / expected : 0.0);
    largestLeftOutError_ = std::max(largestLeftOutError_, error);
    sum += error * error;
  }
  meanLeftOutError_ = std::sqrt(sum / n);
  // Of few ratios the next larger one: the point that is predicted is one more of them.
  model_.calibration = std::max(1.0, quantile(ratios, std::min(1.0, confidence * (n + 1) / n)) / confidentDeviations);
}

double Surrogate::deviation(const System& system, const Points& points, const std::vector<double>& x) const {
  const int n = static_cast<int>(points.size());
  base::Matrix r(n, 1);
  for (int i = 0; i < n; ++i) r(i, 0) = correlation(points[i], x);
  solveTriangular(system.factor, false, r);
  base::Matrix u = column(monomials(x));
  u.multiply(Teuchos::TRANS, Teuchos::NO_TRANS, 1.0, system.trend, r, -1.0);
  solveTriangular(system.trendFactor, false, u);
  const double share = 1.0 - dot(r.values(), r.values(), n) + dot(u.values(), u.values(), u.numRows());
  return model_.calibration * std::sqrt(system_.variance * std::max(share, 0.0));
}

Surrogate::Prediction Surrogate::evaluate(const std::vector<double>& point) const {
  const std::vector<double> x = scaled(point);
  const std::vector<double> f = monomials(x);
  Prediction prediction;
  prediction.value = std::inner_product(f.begin(), f.end(), system_.coefficients.begin(), 0.0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    prediction.value += system_.weights[i] * correlation(points_[i], x);
  }
  prediction.deviation = deviation(system_, points_, x);
  prediction.isInside = std::all_of(x.begin(), x.end(), [](double c) { return std::abs(c) <= 1.0 + besideTheBox; });
  return prediction;
}

std::vector<double> Surrogate::deviationsWith(const Points& more, const Points& candidates) const {
  Points points = points_;
  std::vector<double> values = values_;
  for (const auto& point : more) {
    points.push_back(scaled(point));
    values.push_back(0.0);
  }
  System system;
  std::vector<double> deviations;
  const bool isSolved = solve(points, values, system);
  for (const auto& candidate : candidates) {
    // A point that is there already makes the correlations singular: it is known.
    deviations.push_back(isSolved ? deviation(system, points, scaled(candidate)) : 0.0);
  }
  return deviations;
}

}  // namespace harmos::design
