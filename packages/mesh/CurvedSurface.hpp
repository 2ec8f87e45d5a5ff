#pragma once

#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// A cylinder, a cone or a sphere that nodes of a mesh lie on; in the plane a circle, the section of cylinder and
/// sphere.
///
/// Fitted to the nodes by least squares of their distances: of facets whose corners lie on a cylinder it is that
/// cylinder, to round-off.
class CurvedSurface {
 public:
  /// What it is.
  enum class Kind { cylinder, cone, sphere };

  /// The circle through places of the plane z = 0 [length]. Throws base::Error (input) where places do not determine
  /// one: fewer than three, or in a line.
  static CurvedSurface circle(const std::vector<base::Vector3>& places);
  /// The sphere through places in space [length]. Throws as circle().
  static CurvedSurface sphere(const std::vector<base::Vector3>& places);
  /// The cylinder through places in space [length]; `normals`: of the faces between them, of any length, to which its
  /// axis is nearly normal. Throws as circle().
  static CurvedSurface cylinder(const std::vector<base::Vector3>& places, const std::vector<base::Vector3>& normals);

  /// The cone through places in space [length]; `normals` as for a cylinder, at nearly one angle to its axis. Throws as
  /// circle().
  static CurvedSurface cone(const std::vector<base::Vector3>& places, const std::vector<base::Vector3>& normals);

  /// The place on the surface beside another [length], straight from the axis or from the centre, so that a rim in a
  /// plane across the axis stays in it; one on the axis, or in the centre, stays where it is.
  base::Vector3 nearest(const base::Vector3& place) const;
  /// How far a place lies from the surface [length].
  double distance(const base::Vector3& place) const { return base::distance(place, nearest(place)); }
  /// Its radius [length], of a cone that at centre().
  double radius() const { return radius_; }
  /// A point of the axis, or the centre [length].
  const base::Vector3& centre() const { return centre_; }

 private:
  /// From the centre, or from the axis.
  base::Vector3 arm(const base::Vector3& place) const;

  base::Vector3 centre_{};
  base::Vector3 axis_{};  // of length 1; 0 of a sphere
  double radius_ = 0.0;
  double slope_ = 0.0;  // of the radius along the axis, of a cone
};

}  // namespace harmos::mesh
