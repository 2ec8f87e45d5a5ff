#include <harmos/parametric/Trust.hpp>

#include <cmath>

namespace harmos::parametric {

double falseClaimBound(int audits, int found) {
  if (found >= audits) return 1.0;
  const auto probabilityOfAtMost = [&](double share) {
    double term = std::pow(1.0 - share, audits);
    double sum = term;
    for (int k = 1; k <= found; ++k) {
      term *= (audits - k + 1.0) / k * share / (1.0 - share);
      sum += term;
    }
    return sum;
  };
  double below = 0.0, above = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (below + above);
    (probabilityOfAtMost(middle) >= 0.05 ? below : above) = middle;
  }
  return above;
}

}  // namespace harmos::parametric
