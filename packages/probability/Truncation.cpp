#include <harmos/probability/Truncation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace harmos::probability {
namespace {

// Of the energies of a kinked function over the degrees.
constexpr double decay = 2.5;
// Of order 1 the linear part does not tell the kink: its residual over the linear term is 0.25 to 1.3 for kinks within
// a standard deviation.
constexpr double besideTheLinear = 0.6;
// Slower geometric series are not believed.
constexpr double slowest = 0.9;

/// Variance in the polynomials of every degree, from 0.
std::vector<double> energies(const Expansion& expansion) {
  std::vector<double> sums(static_cast<std::size_t>(expansion.basis().order()) + 1, 0.0);
  const auto& indices = expansion.basis().indices();
  for (std::size_t a = 0; a < indices.size(); ++a) {
    const int degree = std::accumulate(indices[a].begin(), indices[a].end(), 0);
    sums[degree] += expansion.coefficients()[a] * expansion.coefficients()[a];
  }
  return sums;
}

}  // namespace

double kinkedResidual(const Expansion& expansion) {
  const int order = expansion.basis().order();
  const std::vector<double> energy = energies(expansion);
  if (order == 0) return std::numeric_limits<double>::quiet_NaN();
  if (order == 1) return besideTheLinear * std::sqrt(energy[1]);
  double found = 0.0, expected = 0.0;
  for (int degree = 2; degree <= order; ++degree) {
    found += energy[degree];
    expected += std::pow(degree, -decay);
  }
  return std::sqrt(found / expected * std::pow(order, 1.0 - decay) / (decay - 1.0));
}

double smoothResidual(const Expansion& expansion) {
  const int order = expansion.basis().order();
  const std::vector<double> energy = energies(expansion);
  if (order == 0) return std::numeric_limits<double>::quiet_NaN();
  const double last = energy[order];
  if (order == 1 || !(energy[order - 1] > 0.0)) return std::sqrt(last);
  const double ratio = std::min(last / energy[order - 1], slowest);
  return std::sqrt(last * ratio / (1.0 - ratio));
}

}  // namespace harmos::probability
