#include <harmos/mortar/detail/PolygonQuadrature.hpp>

#include <deque>

#include <boost/math/special_functions/legendre.hpp>

namespace harmos::mortar {
namespace {

/// Gauss' rule on [0, 1].
struct LineRule {
  explicit LineRule(int count) {
    for (const double zero : boost::math::legendre_p_zeros<double>(count)) {
      const double slope = boost::math::legendre_p_prime(count, zero);
      const double share = 1.0 / ((1.0 - zero * zero) * slope * slope);
      for (const double sign : {-1.0, 1.0}) {
        if (zero == 0.0 && sign > 0.0) continue;
        place.push_back(0.5 + 0.5 * sign * zero);
        weight.push_back(share);
      }
    }
  }
  std::vector<double> place, weight;
};

/// Rules of 1, 2, ... points, made when they are asked for. Per thread, for their number grows.
const LineRule& lineRule(int count) {
  thread_local std::deque<LineRule> rules;
  while (static_cast<int>(rules.size()) < count) rules.emplace_back(static_cast<int>(rules.size()) + 1);
  return rules[count - 1];
}

}  // namespace

void integratePolygon(const ConvexPolygon& polygon, int degree, std::vector<QuadraturePoint>& points) {
  points.clear();
  if (polygon.isSegment()) {
    const LineRule& rule = lineRule(degree / 2 + 1);
    const double from = polygon[0][0], length = polygon.area();
    for (std::size_t i = 0; i < rule.place.size(); ++i) {
      points.push_back({{from + rule.place[i] * length, 0.0}, rule.weight[i] * length});
    }
    return;
  }
  const LineRule& rule = lineRule((degree + 1) / 2 + 1);  // the collapse costs a degree
  for (int t = 2; t < polygon.corners(); ++t) {
    const Flat &a = polygon[0], &b = polygon[t - 1], &c = polygon[t];
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    for (std::size_t i = 0; i < rule.place.size(); ++i) {
      for (std::size_t j = 0; j < rule.place.size(); ++j) {
        const double first = rule.place[i], second = (1.0 - first) * rule.place[j];
        points.push_back({{a[0] + first * (b[0] - a[0]) + second * (c[0] - a[0]),
                           a[1] + first * (b[1] - a[1]) + second * (c[1] - a[1])},
                          rule.weight[i] * rule.weight[j] * (1.0 - first) * twice});
      }
    }
  }
}

}  // namespace harmos::mortar
