#pragma once

#include <vector>

#include <harmos/latin/ModelParameter.hpp>

namespace harmos::latin {

/// One value that a difference with respect to a parameter asks for.
struct DifferencePoint {
  double offset;  ///< from the value of the parameter
  double weight;  ///< [1 / unit of the parameter]
};

/// The points of a difference of second order, ascending and equally far apart.
inline std::vector<DifferencePoint> differenceOf(ModelParameter::Side side, double step) {
  std::vector<DifferencePoint> points;
  switch (side) {
    case ModelParameter::Side::both:
      points = {{-1.0, -0.5}, {0.0, 0.0}, {1.0, 0.5}};
      break;
    case ModelParameter::Side::above:
      points = {{0.0, -1.5}, {1.0, 2.0}, {2.0, -0.5}};
      break;
    case ModelParameter::Side::below:
      points = {{-2.0, 0.5}, {-1.0, -2.0}, {0.0, 1.5}};
      break;
  }
  for (DifferencePoint& point : points) {
    point.offset *= step;
    point.weight /= step;
  }
  return points;
}

/// What these points make of values at them, each a row of load steps, at one of these.
inline double slopeOf(const std::vector<DifferencePoint>& points, const std::vector<std::vector<double>>& values,
                      int step) {
  double sum = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v) sum += points[v].weight * values[v][step];
  return sum;
}

}  // namespace harmos::latin
