#include <harmos/probability/Normal.hpp>

#include <cmath>

#include <harmos/probability/detail/Require.hpp>
#include <harmos/probability/detail/StandardNormal.hpp>

namespace harmos::probability {

Normal::Normal(double mean, double standardDeviation) : mean_(mean), deviation_(standardDeviation) {
  require(std::isfinite(mean), "Normal distribution: the mean must be a finite number.");
  require(
      standardDeviation >= 0.0 && std::isfinite(standardDeviation),
      "Normal distribution: the standard deviation must be at least 0, not " + base::toText(standardDeviation) + ".");
}

double Normal::germ(double u) const {
  return normalQuantile(u);
}

double Normal::germExceeded(double v) const {
  return -normalQuantile(v);
}

double Normal::cumulative(double x) const {
  if (deviation_ == 0.0) return x < mean_ ? 0.0 : 1.0;
  return normalCumulative((x - mean_) / deviation_);
}

}  // namespace harmos::probability
