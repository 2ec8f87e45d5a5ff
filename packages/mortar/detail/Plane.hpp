#pragma once

#include <array>

#include <harmos/base/Vector3.hpp>

namespace harmos::mortar {

/// A place on a plane [length]; in 2-D on a line, the second one 0.
using Flat = std::array<double, 2>;

/// A plane (in 2-D a line) with two axes, (first, second, normal) right-handed.
class Plane {
 public:
  /// `normal`: a unit vector. In 2-D the second axis is z.
  Plane(const base::Vector3& origin, const base::Vector3& normal, int dimension);

  /// Where a point [length] lies when seen along the normal.
  Flat project(const base::Vector3& point) const {
    const base::Vector3 arm = point - origin_;
    return {dot(arm, first_), dot(arm, second_)};
  }
  /// The point [length] of the plane at a place.
  base::Vector3 pointAt(const Flat& place) const { return origin_ + place[0] * first_ + place[1] * second_; }
  /// Height [length] of a point over the plane.
  double height(const base::Vector3& point) const { return dot(point - origin_, normal_); }
  /// Height [length] at a place of another plane (through `point`, with the normal `other`, not across this one's).
  double heightOf(const base::Vector3& point, const base::Vector3& other, const Flat& at) const;

 private:
  base::Vector3 origin_, normal_, first_, second_;
};

}  // namespace harmos::mortar
