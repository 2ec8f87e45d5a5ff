#pragma once

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// How far a plane mesh reaches out of its plane: by a thickness [length], or once around the axis y.
class Depth {
 public:
  /// The same thickness everywhere.
  Depth(double thickness = 1.0) : thickness_(thickness) {}
  /// The circumference 2 pi x, x the radius.
  static Depth revolved() {
    Depth depth;
    depth.isRevolved_ = true;
    return depth;
  }

  /// At a place of the mesh [length].
  double at(const base::Vector3& place) const {
    constexpr double pi = 3.14159265358979323846;
    return isRevolved_ ? 2.0 * pi * place[0] : thickness_;
  }
  /// Whether it is a circumference.
  bool isRevolved() const { return isRevolved_; }

  /// Up to which share of the largest radius nodes lie on the axis: coordinates that are 0 but for rounding.
  static constexpr double onAxis = 1e-9;

 private:
  double thickness_;
  bool isRevolved_ = false;
};

}  // namespace harmos::mesh
