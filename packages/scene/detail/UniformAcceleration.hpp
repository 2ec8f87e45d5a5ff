#pragma once

#include <array>
#include <string>

#include <harmos/scene/detail/VolumeLoad.hpp>

namespace harmos::scene {

/// An acceleration that is the same at all places: `sign` times the entries X, Y and Z.
class UniformAcceleration final : public VolumeLoad {
 public:
  /// Declares X, Y and Z, each of which may follow a history; `doc` says what one of them is.
  static void describe(input::ParameterSpec& spec, const std::string& doc);
  /// Throws base::Error (input) when it leaves the plane, or would not be the same around the axis of axisymmetry.
  UniformAcceleration(const input::Parameters& parameters, elasticity::Kinematics kinematics, double sign);

  elasticity::AffineField acceleration(int step) const override;

 private:
  std::array<input::Schedule, 3> value_;
  double sign_;
};

}  // namespace harmos::scene
