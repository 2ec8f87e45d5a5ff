#include <harmos/probability/Expansion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <harmos/base/Error.hpp>

namespace harmos::probability {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

// Product of three orthonormal polynomials below which its mean is 0 but for round-off.
constexpr double vanishing = 1e-13;

double varianceOf(const std::vector<double>& coefficients) {
  return std::inner_product(coefficients.begin() + 1, coefficients.end(), coefficients.begin() + 1, 0.0);
}

using Coefficients = std::map<std::vector<int>, double>;

/// E[p_i p_j p_k] of one germ at [i][j][k], i and j up to `order`, k up to i + j or the last degree that there is.
std::vector<std::vector<std::vector<double>>> tripleProducts(const Polynomials& polynomials, int order) {
  const int largest = std::min(2 * order, polynomials.largestDegree());
  const GaussRule rule = polynomials.gauss(2 * order + 1);
  const auto size = static_cast<std::size_t>(order) + 1;
  std::vector<std::vector<std::vector<double>>> products(size, std::vector<std::vector<double>>(size));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      products[i][j].assign(std::min(i + j, static_cast<std::size_t>(largest)) + 1, 0.0);
  }
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const std::vector<double> p = polynomials.evaluate(rule.points[q], largest);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        for (std::size_t k = 0; k < products[i][j].size(); ++k)
          products[i][j][k] += rule.weights[q] * p[i] * p[j] * p[k];
      }
    }
  }
  return products;
}

/// Coefficients of (Y - E[Y])^2 by the degrees of their polynomials.
Coefficients squareOf(const Expansion& expansion) {
  const Basis& basis = expansion.basis();
  std::vector<std::vector<std::vector<std::vector<double>>>> products;
  for (int g = 0; g < basis.variables().dimension(); ++g)
    products.push_back(tripleProducts(basis.variables().polynomials(g), basis.order()));
  Coefficients square;
  for (std::size_t a = 1; a < basis.indices().size(); ++a) {
    for (std::size_t b = 1; b <= a; ++b) {
      const double factor = (a == b ? 1.0 : 2.0) * expansion.coefficients()[a] * expansion.coefficients()[b];
      if (factor == 0.0) continue;
      std::vector<std::pair<std::vector<int>, double>> terms{{{}, factor}};
      for (std::size_t g = 0; g < products.size(); ++g) {
        const auto& product = products[g][basis.indices()[a][g]][basis.indices()[b][g]];
        std::vector<std::pair<std::vector<int>, double>> longer;
        for (const auto& [index, value] : terms) {
          for (std::size_t k = 0; k < product.size(); ++k) {
            if (std::abs(product[k]) < vanishing) continue;
            longer.emplace_back(index, value * product[k]);
            longer.back().first.push_back(static_cast<int>(k));
          }
        }
        terms = std::move(longer);
      }
      for (const auto& [index, value] : terms) square[index] += value;
    }
  }
  return square;
}

/// E[(Y - E[Y])^power] / standard deviation^power, power 3 or 4.
double standardisedMoment(const Expansion& expansion, int power) {
  const double deviation = expansion.standardDeviation();
  if (!(deviation > 0.0)) return notANumber;
  const Basis& basis = expansion.basis();
  const int points = power * basis.order() / 2 + 1;
  double moment = 0.0;
  if (std::pow(points, basis.variables().dimension()) <= mostPointsWithoutSolves) {
    const Quadrature quadrature = tensorQuadrature(basis.variables(), points);
    for (std::size_t q = 0; q < quadrature.weights.size(); ++q) {
      const double distance = expansion.evaluate(quadrature.points[q]) - expansion.mean();
      moment += quadrature.weights[q] * std::pow(distance / deviation, power);
    }
    return moment;
  }
  // In many germs a grid has far more points than the square of the expansion has terms.
  const Coefficients square = squareOf(expansion);
  if (power == 4) {
    for (const auto& term : square) moment += term.second * term.second;
  } else {
    for (std::size_t a = 1; a < basis.indices().size(); ++a) {
      const auto term = square.find(basis.indices()[a]);
      if (term != square.end()) moment += expansion.coefficients()[a] * term->second;
    }
  }
  return moment / std::pow(deviation, power);
}

}  // namespace

Expansion::Expansion(std::shared_ptr<const Basis> basis, std::vector<double> coefficients)
    : basis_(std::move(basis)), coefficients_(std::move(coefficients)) {
  if (static_cast<int>(coefficients_.size()) != basis_->size())
    throw base::Error("an expansion needs one coefficient for each polynomial of its basis");
}

double Expansion::evaluate(const std::vector<double>& germs) const {
  const std::vector<double> psi = basis_->evaluate(germs);
  return std::inner_product(psi.begin(), psi.end(), coefficients_.begin(), 0.0);
}

double Expansion::standardDeviation() const {
  return std::sqrt(varianceOf(coefficients_));
}

double Expansion::skewness() const {
  return standardisedMoment(*this, 3);
}

double Expansion::kurtosis() const {
  return standardisedMoment(*this, 4);
}

double Expansion::lastDegreeShare() const {
  const double variance = varianceOf(coefficients_);
  if (!(variance > 0.0)) return notANumber;
  double share = 0.0;
  for (std::size_t a = 1; a < coefficients_.size(); ++a) {
    const std::vector<int>& index = basis_->indices()[a];
    if (std::accumulate(index.begin(), index.end(), 0) == basis_->order()) share += coefficients_[a] * coefficients_[a];
  }
  return share / variance;
}

Expansion project(std::shared_ptr<const Basis> basis, const Quadrature& quadrature, const std::vector<double>& values) {
  const base::Matrix toCoefficients = projector(*basis, quadrature);
  std::vector<double> coefficients(basis->size(), 0.0);
  for (int q = 0; q < quadrature.size(); ++q) {
    const double value = values[q];
    for (int a = 0; a < basis->size(); ++a) coefficients[a] += toCoefficients(a, q) * value;
  }
  return {std::move(basis), std::move(coefficients)};
}

std::vector<SobolIndex> sobolIndices(const Expansion& expansion) {
  const auto smallSetsFirst = [](const std::vector<int>& a, const std::vector<int>& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  };
  std::map<std::vector<int>, double, decltype(smallSetsFirst)> parts(smallSetsFirst);
  for (std::size_t a = 1; a < expansion.coefficients().size(); ++a) {
    const std::vector<int>& index = expansion.basis().indices()[a];
    std::vector<int> germs;
    for (std::size_t i = 0; i < index.size(); ++i) {
      if (index[i] > 0) germs.push_back(static_cast<int>(i));
    }
    parts[germs] += expansion.coefficients()[a] * expansion.coefficients()[a];
  }
  const double variance = varianceOf(expansion.coefficients());
  const double scale = variance > 0.0 ? 1.0 / variance : notANumber;
  std::vector<SobolIndex> indices;
  for (const auto& [germs, part] : parts) {
    double total = 0.0;
    for (const auto& [others, otherPart] : parts) {
      if (std::includes(others.begin(), others.end(), germs.begin(), germs.end())) total += otherPart;
    }
    indices.push_back({germs, part * scale, total * scale});
  }
  return indices;
}

}  // namespace harmos::probability
