#pragma once

#include <harmos/design/Design.hpp>

namespace harmos::design {

/// Points that the user has listed.
class ListDesign : public Design {
 public:
  /// One row per point, columns in the order of the axes and in their units.
  explicit ListDesign(std::vector<std::vector<double>> points) : points_(std::move(points)) {}
  /// Throws base::Error (input) when a row has not one value per axis.
  std::vector<std::vector<double>> points(const std::vector<Axis>& axes) const override;

 private:
  std::vector<std::vector<double>> points_;
};

}  // namespace harmos::design
