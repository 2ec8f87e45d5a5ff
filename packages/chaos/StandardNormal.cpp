#include <harmos/chaos/StandardNormal.hpp>

#include <cmath>

#include <boost/math/special_functions/erf.hpp>

#include <harmos/chaos/Require.hpp>

namespace harmos::chaos {

namespace {

const double root2 = std::sqrt(2.0);

}  // namespace

double normalCumulative(double z) {
  return 0.5 * std::erfc(-z / root2);
}

double normalQuantile(double u) {
  return -root2 * boost::math::erfc_inv(2.0 * requireProbability(u));
}

}  // namespace harmos::chaos
