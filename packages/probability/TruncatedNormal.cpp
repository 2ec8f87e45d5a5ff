#include <harmos/probability/TruncatedNormal.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <harmos/probability/detail/Require.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// P(a < Z < b), from that tail in which no digits cancel.
double normalProbability(double a, double b) {
  return a > 0.0 ? normalCumulative(-a) - normalCumulative(-b) : normalCumulative(b) - normalCumulative(a);
}

}  // namespace

TruncatedNormal::TruncatedNormal(double parentMean, double parentDeviation, std::optional<double> lower,
                                 std::optional<double> upper)
    : parentMean_(parentMean), parentDeviation_(parentDeviation) {
  const std::string prefix = "Truncated Normal distribution: ";
  require(std::isfinite(parentMean), prefix + "the mean must be a finite number.");
  require(parentDeviation > 0.0 && std::isfinite(parentDeviation),
          prefix + "the standard deviation must be above 0, not " + base::toText(parentDeviation) +
              "; a parameter that does not vary is given by its value alone.");
  require(lower || upper, prefix + "give a lower bound, an upper bound or both; without any it is Normal.");
  require((!lower || std::isfinite(*lower)) && (!upper || std::isfinite(*upper)),
          prefix + "a bound must be a finite number; leave it out where there is none.");
  require(!lower || !upper || *lower < *upper, prefix + "the lower bound must be below the upper bound.");
  lower_ = lower ? (*lower - parentMean) / parentDeviation : -infinity;
  upper_ = upper ? (*upper - parentMean) / parentDeviation : infinity;
  probability_ = normalProbability(lower_, upper_);
  constexpr double leastProbability = 1e-250;
  require(probability_ > leastProbability,
          prefix +
              "the bounds leave next to nothing of the normal distribution with this mean and standard deviation; "
              "bring them nearer to the mean.");

  // Where the density has fallen to exp(-85) of its largest value, nothing is left for polynomials of any degree used.
  const double peak = std::clamp(0.0, lower_, upper_);
  const double reach = std::sqrt(peak * peak + 170.0);
  const double from = std::max(lower_, -reach), to = std::min(upper_, reach);
  constexpr int panels = 16, pointsPerPanel = 24;
  const GaussRule rule = Polynomials::legendre().gauss(pointsPerPanel);
  const double half = 0.5 * (to - from) / panels;
  std::vector<double> points, weights;
  double total = 0.0, mean = 0.0, variance = 0.0;
  for (int panel = 0; panel < panels; ++panel) {
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      points.push_back(from + half * (2 * panel + 1 + rule.points[q]));
      weights.push_back(rule.weights[q] * std::exp(-0.5 * (points.back() * points.back() - peak * peak)));
      total += weights.back();
    }
  }
  for (std::size_t q = 0; q < points.size(); ++q) {
    weights[q] /= total;
    mean += weights[q] * points[q];
  }
  for (std::size_t q = 0; q < points.size(); ++q) variance += weights[q] * (points[q] - mean) * (points[q] - mean);
  for (double& point : points) point = (point - mean) / std::sqrt(variance);
  mean_ = parentMean + parentDeviation * mean;
  deviation_ = parentDeviation * std::sqrt(variance);
  polynomials_ = Polynomials::discrete(points, weights);
}

double TruncatedNormal::germ(double u) const {
  return germAt(requireProbability(u), 1.0 - u);
}

double TruncatedNormal::germExceeded(double v) const {
  return germAt(1.0 - v, requireProbability(v));
}

/// Of the germ with the probability u below and v above it, u + v = 1.
double TruncatedNormal::germAt(double u, double v) const {
  const double below = normalCumulative(lower_) + u * probability_,
               above = normalCumulative(-upper_) + v * probability_;
  const double z = below < above ? normalQuantile(below) : -normalQuantile(above);
  return (parentMean_ + parentDeviation_ * std::clamp(z, lower_, upper_) - mean_) / deviation_;
}

double TruncatedNormal::cumulative(double x) const {
  const double z = std::clamp((x - parentMean_) / parentDeviation_, lower_, upper_);
  return normalProbability(lower_, z) / probability_;
}

}  // namespace harmos::probability
