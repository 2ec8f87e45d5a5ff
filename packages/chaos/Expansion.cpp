#include <harmos/chaos/Expansion.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <harmos/base/Error.hpp>
#include <harmos/chaos/Quadrature.hpp>

namespace harmos::chaos {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

double varianceOf(const std::vector<double>& coefficients) {
  return std::inner_product(coefficients.begin() + 1, coefficients.end(), coefficients.begin() + 1, 0.0);
}

/// E[(Y - E[Y])^power] / standard deviation^power, power up to 4.
double standardisedMoment(const Expansion& expansion, int power) {
  const double deviation = expansion.standardDeviation();
  if (!(deviation > 0.0)) return notANumber;
  constexpr double mostTensorPoints = 1e4;
  const Basis& basis = expansion.basis();
  const int points = power * basis.order() / 2 + 1;
  const Quadrature quadrature = std::pow(points, basis.variables().dimension()) <= mostTensorPoints
                                    ? tensorQuadrature(basis.variables(), points)
                                    : sparseQuadrature(Basis(basis.variablesPointer(), 2 * basis.order()));
  double moment = 0.0;
  for (std::size_t q = 0; q < quadrature.weights.size(); ++q) {
    const double distance = (expansion.evaluate(quadrature.points[q]) - expansion.mean()) / deviation;
    moment += quadrature.weights[q] * std::pow(distance, power);
  }
  return moment;
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

}  // namespace harmos::chaos
