#pragma once

#include <vector>

#include <harmos/design/Axis.hpp>

/// Designs: which configurations a study solves, from grids to points that follow the results.
namespace harmos::design {

/// Chooses the points of a study in the space of its free parameters.
class Design {
 public:
  virtual ~Design() = default;
  /// One row per point, one column per axis, each in the unit of its parameter. The same axes give the same points, on
  /// every machine and rank.
  virtual std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const = 0;
};

}  // namespace harmos::design
