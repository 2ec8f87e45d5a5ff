#include <harmos/probability/Uniform.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

Uniform::Uniform(double lower, double upper) : lower_(lower), upper_(upper) {
  require(std::isfinite(lower) && std::isfinite(upper) && lower < upper,
          "Uniform distribution: the lower bound, " + base::toText(lower) + ", must be below the upper bound, " +
              base::toText(upper) + ".");
}

double Uniform::standardDeviation() const {
  return (upper_ - lower_) / std::sqrt(12.0);
}

double Uniform::germ(double u) const {
  return 2.0 * requireProbability(u) - 1.0;
}

double Uniform::germExceeded(double v) const {
  return 1.0 - 2.0 * requireProbability(v);
}

double Uniform::cumulative(double x) const {
  return std::clamp((x - lower_) / (upper_ - lower_), 0.0, 1.0);
}

}  // namespace harmos::probability
