#include <harmos/probability/Polynomials.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <Stokhos_HermiteBasis.hpp>
#include <Stokhos_JacobiBasis.hpp>
#include <Stokhos_LegendreBasis.hpp>
#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>

namespace harmos::probability {

namespace {

constexpr int largestKnownDegree = 128;
constexpr std::size_t mostDiscretePolynomials = 65;

using Recurrence = std::pair<std::vector<double>, std::vector<double>>;

/// Of normalised polynomials, whose beta is sqrt(b).
Recurrence recurrenceOf(const Stokhos::RecurrenceBasis<int, double>& basis) {
  Teuchos::Array<double> alpha, beta, delta, gamma;
  basis.getRecurrenceCoefficients(alpha, beta, delta, gamma);
  Recurrence recurrence{alpha.toVector(), beta.toVector()};
  for (double& b : recurrence.second) b *= b;
  return recurrence;
}

double dot(const std::vector<double>& x, const std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

std::string degreeError(int degree, int largest) {
  return "a polynomial of degree " + std::to_string(degree) + " is asked for, but this germ has none above degree " +
         std::to_string(largest);
}

}  // namespace

Polynomials Polynomials::hermite() {
  return Polynomials(recurrenceOf(Stokhos::HermiteBasis<int, double>(largestKnownDegree, true)));
}

Polynomials Polynomials::legendre() {
  return Polynomials(recurrenceOf(Stokhos::LegendreBasis<int, double>(largestKnownDegree, true)));
}

Polynomials Polynomials::jacobi(double alpha, double beta) {
  if (!(alpha > -1.0 && beta > -1.0)) throw base::Error("Jacobi polynomials need exponents above -1");
  Recurrence recurrence = recurrenceOf(Stokhos::JacobiBasis<int, double>(largestKnownDegree, alpha, beta, true));
  // Stokhos divides zero by zero in these where alpha + beta is 0 or -1.
  const double sum = alpha + beta;
  recurrence.first[0] = (beta - alpha) / (sum + 2.0);
  recurrence.second[1] = 4.0 * (1.0 + alpha) * (1.0 + beta) / ((sum + 2.0) * (sum + 2.0) * (sum + 3.0));
  return Polynomials(std::move(recurrence));
}

Polynomials Polynomials::discrete(const std::vector<double>& points, const std::vector<double>& probabilities) {
  if (points.empty() || points.size() != probabilities.size())
    throw base::Error("a discrete germ needs one probability for each of its values, and at least one value");
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
  std::vector<double> x, weight;
  double total = 0.0;
  for (const std::size_t i : order) {
    if (!(probabilities[i] >= 0.0)) throw base::Error("the probabilities of a discrete germ must not be negative");
    total += probabilities[i];
    if (!x.empty() && x.back() == points[i]) {
      weight.back() += probabilities[i];
    } else {
      x.push_back(points[i]);
      weight.push_back(probabilities[i]);
    }
  }
  if (!(std::abs(total - 1.0) < 1e-6)) throw base::Error("the probabilities of a discrete germ must add up to 1");

  // The vectors p_k(x_i) sqrt(w_i) are orthonormal. They are made so against all earlier ones, twice: the recurrence
  // alone loses orthogonality when the degree comes near the number of points.
  std::vector<std::vector<double>> vectors(1);
  for (const double w : weight) vectors[0].push_back(std::sqrt(w / total));
  const double breakdown = 1e-13 * (x.back() - x.front());
  Recurrence recurrence{{}, {1.0}};
  for (;;) {
    const std::vector<double>& last = vectors.back();
    std::vector<double> next(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) next[i] = x[i] * last[i];
    recurrence.first.push_back(dot(next, last));
    if (vectors.size() == std::min(x.size(), mostDiscretePolynomials)) break;
    for (int pass = 0; pass < 2; ++pass) {
      for (const auto& vector : vectors) {
        const double part = dot(next, vector);
        for (std::size_t i = 0; i < x.size(); ++i) next[i] -= part * vector[i];
      }
    }
    const double norm = std::sqrt(dot(next, next));
    if (norm <= breakdown) break;
    for (double& value : next) value /= norm;
    recurrence.second.push_back(norm * norm);
    vectors.push_back(std::move(next));
  }
  const bool isFinite = vectors.size() == x.size();
  return Polynomials(std::move(recurrence), isFinite);
}

Polynomials Polynomials::recurrence(std::vector<double> a, std::vector<double> b) {
  const auto isPositive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (a.empty() || a.size() != b.size() || !std::all_of(b.begin(), b.end(), isPositive))
    throw base::Error("these are no coefficients of orthonormal polynomials", base::ExitCode::input);
  return Polynomials({std::move(a), std::move(b)});
}

std::vector<double> Polynomials::evaluate(double xi, int degree) const {
  if (degree < 0 || degree > largestDegree()) throw base::Error(degreeError(degree, largestDegree()));
  std::vector<double> p(static_cast<std::size_t>(degree) + 1, 1.0);
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    p[i + 1] = ((xi - a_[i]) * p[i] - (i > 0 ? std::sqrt(b_[i]) * p[i - 1] : 0.0)) / std::sqrt(b_[i + 1]);
  }
  return p;
}

GaussRule Polynomials::gauss(int count) const {
  if (isFinite_) count = std::min(count, largestDegree() + 1);
  if (count < 1 || count > largestDegree() + 1) throw base::Error(degreeError(count - 1, largestDegree()));
  const auto n = static_cast<std::size_t>(count);
  // Golub and Welsch, Math. Comput. 23 (1969): the points are the eigenvalues of the matrix of the recurrence, the
  // weights the squares of the first components of its eigenvectors.
  GaussRule rule;
  rule.points.assign(a_.begin(), a_.begin() + count);
  std::vector<double> offDiagonal(n), eigenvectors(n * n), work(2 * n);
  for (std::size_t i = 0; i + 1 < n; ++i) offDiagonal[i] = std::sqrt(b_[i + 1]);
  int info = 0;
  Teuchos::LAPACK<int, double>().STEQR('I', count, rule.points.data(), offDiagonal.data(), eigenvectors.data(), count,
                                       work.data(), &info);
  if (info != 0) throw base::Error("the points of a Gauss rule were not found");
  for (std::size_t q = 0; q < n; ++q) rule.weights.push_back(eigenvectors[q * n] * eigenvectors[q * n]);
  return rule;
}

}  // namespace harmos::probability
