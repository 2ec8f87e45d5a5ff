#pragma once

#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// A cylinder or a sphere that nodes of a mesh lie on; in the plane a circle, which is the section of either.
///
/// Fitted to the nodes by least squares of their distances: of facets whose corners lie on a cylinder it is that
/// cylinder, to round-off.
class CurvedSurface {
 public:
  /// What it is.
  enum class Kind { cylinder, sphere };

  /// The circle through places of the plane z = 0 [length]. Throws base::Error (input) where places do not determine
  /// one: fewer than three, or in a line.
  static CurvedSurface circle(const std::vector<base::Vector3>& places);
  /// The sphere through places in space [length]. Throws as circle().
  static CurvedSurface sphere(const std::vector<base::Vector3>& places);
  /// The cylinder through places in space [length]; `normals`: of the faces between them, of any length, to which its
  /// axis is nearly normal. Throws as circle().
  static CurvedSurface cylinder(const std::vector<base::Vector3>& places, const std::vector<base::Vector3>& normals);

  /// The place on the surface next to another [length]; one on the axis, or in the centre, stays where it is.
  base::Vector3 nearest(const base::Vector3& place) const;
  /// How far a place lies from the surface [length].
  double distance(const base::Vector3& place) const { return base::distance(place, nearest(place)); }
  /// Its radius [length].
  double radius() const { return radius_; }
  /// A point of the axis, or the centre [length].
  const base::Vector3& centre() const { return centre_; }

 private:
  /// From the centre, or from the axis.
  base::Vector3 arm(const base::Vector3& place) const;

  base::Vector3 centre_{};
  base::Vector3 axis_{};  // of length 1; 0 of a sphere
  double radius_ = 0.0;
};

}  // namespace harmos::mesh
