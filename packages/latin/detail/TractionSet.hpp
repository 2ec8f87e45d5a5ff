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
  /// A closed contact that slides: pressure with the friction that goes with it. `direction`: any multiple > 0 of it.
  static TractionSet ray(const base::Vector3& direction);
  /// A closed contact that sticks: t.n <= 0, |t - (t.n) n| <= friction |t.n|; n and the tangents are of `frame`. In
  /// the plane the second tangent counts for nothing.
  static TractionSet cone(const base::Frame& frame, double friction, int dimension);

  /// An orthonormal basis of the differences of its tractions; none: a point.
  const std::vector<base::Vector3>& hull() const { return hull_; }
  /// The traction of the set that is nearest to `x`.
  base::Vector3 nearest(const base::Vector3& x) const;
  /// Whether the set holds all multiples of its hull, added to one traction.
  bool isSpan() const { return kind_ == Kind::span; }
  /// Unit vectors whose sums with factors >= 0 are the set, if it is no span: exact in the plane; in space as many as
  /// `count` on a cone, the first along the friction of `traction`.
  std::vector<base::Vector3> generators(const base::Vector3& traction, int count) const;

 private:
  enum class Kind { span, ray, cone };

  Kind kind_ = Kind::span;
  base::Vector3 base_{};             // of a span
  std::vector<base::Vector3> hull_;  // of a ray: the unit vector along it
  base::Frame frame_{};              // of a cone
  double friction_ = 0.0;
  int dimension_ = 3;
};

}  // namespace harmos::latin
