#pragma once

#include <vector>

#include <harmos/assembly/Interface.hpp>
#include <harmos/base/Vector3.hpp>

namespace harmos::latin {

/// The tractions that the law of a pair admits at the jump that was found: a convex set, in global components.
class TractionSet {
 public:
  /// One traction only.
  static TractionSet point(const base::Vector3& traction);
  /// A traction, and all that differ from it along unit vectors at right angles.
  static TractionSet span(const base::Vector3& traction, std::vector<base::Vector3> axes);
  /// A closed contact that slides: pressure with the friction that goes with it. `direction`: any multiple > 0 of it;
  /// `begin` [stress]: what is there without pressure.
  static TractionSet ray(const base::Vector3& direction, const base::Vector3& begin = base::Vector3{});
  /// A closed contact that sticks: t.n <= 0, |t - (t.n) n| <= cohesion + friction |t.n|; n and the tangents are of
  /// `frame`. In the plane the second tangent counts for nothing. [-], [stress].
  static TractionSet cone(const base::Frame& frame, double friction, int dimension, double cohesion = 0.0);

  /// An orthonormal basis of the differences of its tractions; none: a point.
  const std::vector<base::Vector3>& hull() const { return hull_; }
  /// The traction of the set that is nearest to `x`.
  base::Vector3 nearest(const base::Vector3& x) const;
  /// Whether more pressure along the normal n brings more friction, or may.
  bool hasFriction(const base::Vector3& n) const;
  /// Whether the set holds all multiples of its hull, added to one traction.
  bool isSpan() const { return kind_ == Kind::span; }
  /// Where a ray begins, and 0 of a cone [stress].
  const base::Vector3& begin() const { return base_; }
  /// Unit vectors whose sums with factors >= 0, added to begin(), are the set, if it is no span and without cohesion:
  /// exact in the plane; in space as many as `count` on a cone, the first along the friction of `traction`.
  std::vector<base::Vector3> generators(const base::Vector3& traction, int count) const;
  /// Vectors across a cone [stress], which cohesion adds with factors from -1 to 1: all in the plane, a square within
  /// in space.
  std::vector<base::Vector3> cohesions() const;

 private:
  enum class Kind { span, ray, cone };

  Kind kind_ = Kind::span;
  base::Vector3 base_{};             // of a span and a ray
  std::vector<base::Vector3> hull_;  // of a ray: the unit vector along it
  base::Frame frame_{};              // of a cone
  double friction_ = 0.0, cohesion_ = 0.0;
  int dimension_ = 3;
};

}  // namespace harmos::latin
