#include <harmos/probability/Lognormal.hpp>

#include <cmath>

#include <harmos/probability/detail/Require.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {

Lognormal::Lognormal(double mean, double standardDeviation) : mean_(mean), deviation_(standardDeviation) {
  require(mean > 0.0 && std::isfinite(mean), "Lognormal distribution: the mean must be above 0, not " +
                                                 base::toText(mean) +
                                                 "; mean and standard deviation are those of the parameter itself, not "
                                                 "of its logarithm.");
  require(standardDeviation >= 0.0 && std::isfinite(standardDeviation),
          "Lognormal distribution: the standard deviation must be at least 0, not " + base::toText(standardDeviation) +
              ".");
  const double ratio = standardDeviation / mean;
  logDeviation_ = std::sqrt(std::log1p(ratio * ratio));
  logMean_ = std::log(mean) - 0.5 * logDeviation_ * logDeviation_;
}

double Lognormal::value(double germ) const {
  return std::exp(logMean_ + logDeviation_ * germ);
}

double Lognormal::germ(double u) const {
  return normalQuantile(u);
}

double Lognormal::germExceeded(double v) const {
  return -normalQuantile(v);
}

double Lognormal::cumulative(double x) const {
  if (logDeviation_ == 0.0) return x < mean_ ? 0.0 : 1.0;
  return x > 0.0 ? normalCumulative((std::log(x) - logMean_) / logDeviation_) : 0.0;
}

}  // namespace harmos::probability
