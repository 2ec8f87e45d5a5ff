#include <harmos/probability/Beta.hpp>

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/beta.hpp>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

namespace {

double checkedShape(const char* parameter, double value) {
  require(value > 0.0 && std::isfinite(value), std::string("Beta distribution: the shape ") + parameter +
                                                   " must be above 0, not " + base::toText(value) +
                                                   "; 1 and 1 make it uniform, larger values gather it in the middle.");
  return value;
}

/// The share of the range that is not exceeded with the probability u. Below machine precision Boost's search may fail,
/// and no sample goes there.
double shareAt(double u, double alpha, double beta) {
  return boost::math::ibeta_inv(alpha, beta, std::max(requireProbability(u), 1e-16));
}

}  // namespace

Beta::Beta(double lower, double upper, double alpha, double beta)
    : lower_(lower),
      upper_(upper),
      alpha_(checkedShape("alpha", alpha)),
      beta_(checkedShape("beta", beta)),
      polynomials_(Polynomials::jacobi(beta - 1.0, alpha - 1.0)) {
  require(std::isfinite(lower) && std::isfinite(upper) && lower < upper,
          "Beta distribution: the lower bound, " + base::toText(lower) + ", must be below the upper bound, " +
              base::toText(upper) + ".");
}

double Beta::mean() const {
  return lower_ + (upper_ - lower_) * alpha_ / (alpha_ + beta_);
}

double Beta::standardDeviation() const {
  const double sum = alpha_ + beta_;
  return (upper_ - lower_) / sum * std::sqrt(alpha_ * beta_ / (sum + 1.0));
}

double Beta::value(double germ) const {
  return 0.5 * (lower_ + upper_) + 0.5 * (upper_ - lower_) * germ;
}

double Beta::germ(double u) const {
  return 2.0 * shareAt(u, alpha_, beta_) - 1.0;
}

double Beta::germExceeded(double v) const {
  return 1.0 - 2.0 * shareAt(v, beta_, alpha_);
}

double Beta::cumulative(double x) const {
  if (x <= lower_) return 0.0;
  if (x >= upper_) return 1.0;
  return boost::math::ibeta(alpha_, beta_, (x - lower_) / (upper_ - lower_));
}

}  // namespace harmos::probability
