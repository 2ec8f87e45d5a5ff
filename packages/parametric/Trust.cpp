#include <harmos/parametric/Trust.hpp>

#include <algorithm>
#include <cmath>

namespace harmos::parametric {
namespace {

// Probability below which a number of false claims is not believed: confidence of 95 %.
constexpr double disbelief = 0.05;

}  // namespace

void Trust::addAudit(double error) {
  ++audits;
  if (error > 1.0) ++falseClaims;
  largestAudit = std::max(largestAudit, error);
  falseClaimBound = parametric::falseClaimBound(audits, falseClaims);
}

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
    (probabilityOfAtMost(middle) >= disbelief ? below : above) = middle;
  }
  return above;
}

}  // namespace harmos::parametric
