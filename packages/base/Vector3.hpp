#pragma once

#include <array>
#include <cmath>

namespace harmos::base {

/// Three components of a place, a displacement or a traction: (x, y, z), or (n, t1, t2) in the frame of an interface.
/// In 2-D the third one is 0. [length] or [stress], as it is used; a new one is not zero unless made with {}.
struct Vector3 : std::array<double, 3> {};

/// a + b, component by component; both in one frame and unit.
inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
/// a - b, component by component; both in one frame and unit.
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// s a.
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
/// a.b, in the product of their units.
inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
/// a x b, right-handed, in the product of their units.
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// |a| = sqrt(a.a), in its unit.
inline double norm(const Vector3& a) {
  return std::sqrt(dot(a, a));
}
/// |a - b|, in their unit.
inline double distance(const Vector3& a, const Vector3& b) {
  return norm(a - b);
}
/// Length of the part in the plane of an interface, sqrt(t1^2 + t2^2), of a vector (n, t1, t2).
inline double tangentialNorm(const Vector3& v) {
  return std::hypot(v[1], v[2]);
}

/// Rows of an orthogonal matrix Q. Of an interface: the unit vectors n, t1, t2 with n from side 1 to side 2 (out of
/// side 1), right-handed; in 2-D t2 = (0, 0, 1).
using Frame = std::array<Vector3, 3>;

/// Q v: the components along the rows of the frame of a vector (x, y, z).
inline Vector3 toFrame(const Frame& frame, const Vector3& v) {
  return {dot(frame[0], v), dot(frame[1], v), dot(frame[2], v)};
}
/// Q^T v: the components (x, y, z) of a vector given along the rows of the frame.
inline Vector3 toGlobal(const Frame& frame, const Vector3& v) {
  return {frame[0][0] * v[0] + frame[1][0] * v[1] + frame[2][0] * v[2],
          frame[0][1] * v[0] + frame[1][1] * v[1] + frame[2][1] * v[2],
          frame[0][2] * v[0] + frame[1][2] * v[1] + frame[2][2] * v[2]};
}

}  // namespace harmos::base
