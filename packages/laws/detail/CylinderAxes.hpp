#pragma once

#include <harmos/base/Tensor3.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/input/ParameterSpec.hpp>
#include <harmos/input/Parameters.hpp>

namespace harmos::laws {

/// The radial, tangential and axial direction about an axis, right-handed.
class CylinderAxes {
 public:
  /// Declares Point and Axis; in the plane the axis is z.
  static void describe(input::ParameterSpec& p);
  /// Throws base::Error(input) when they are no axis.
  explicit CylinderAxes(const input::Parameters& p);

  /// Rows: e_r, e_t, e_a at a place [length]; on the axis e_r and e_t are 0.
  base::Frame at(const base::Vector3& place) const;

 private:
  base::Vector3 point_{};
  base::Vector3 axis_{0.0, 0.0, 1.0};
};

}  // namespace harmos::laws
