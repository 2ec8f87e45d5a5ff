#include <harmos/probability/detail/StandardNormal.hpp>

#include <cmath>

#include <boost/math/special_functions/erf.hpp>

#include <harmos/probability/detail/Require.hpp>

namespace harmos::probability {

namespace {

const double root2 = std::sqrt(2.0);

}  // namespace

double normalCumulative(double z) {
  return 0.5 * std::erfc(-z / root2);
}

double normalQuantile(double u) {
  return -root2 * boost::math::erfc_inv(2.0 * requireProbability(u));
}

}  // namespace harmos::probability
