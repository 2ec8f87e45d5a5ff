#pragma once

#include <algorithm>

#include <harmos/base/Vector3.hpp>

namespace harmos::base {

/// Rows of a 3 x 3 matrix, in the axes and the unit of what it holds; a new one is not zero unless made with {}.
using Tensor3 = std::array<Vector3, 3>;

/// A v.
inline Vector3 product(const Tensor3& a, const Vector3& v) {
  return {dot(a[0], v), dot(a[1], v), dot(a[2], v)};
}
/// A + s v v^T, in place; s in the unit of A when v is a unit vector.
inline void addDyad(Tensor3& a, double s, const Vector3& v) {
  for (std::size_t i = 0; i < 3; ++i) a[i] = a[i] + (s * v[i]) * v;
}
/// Q^T A Q: the matrix that acts on vectors before they are turned by Q as A does afterwards.
inline Tensor3 turnedBack(const Frame& q, const Tensor3& a) {
  Tensor3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 axis{};
    axis[i] = 1.0;
    result[i] = toGlobal(q, product(a, toFrame(q, axis)));
  }
  // Column by column what was wanted row by row.
  return {Vector3{result[0][0], result[1][0], result[2][0]}, Vector3{result[0][1], result[1][1], result[2][1]},
          Vector3{result[0][2], result[1][2], result[2][2]}};
}
/// Largest difference of the entries of two matrices.
inline double distance(const Tensor3& a, const Tensor3& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  }
  return largest;
}

}  // namespace harmos::base
