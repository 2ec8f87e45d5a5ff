#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>

namespace harmos::scene {

/// All directions that follow from some: a point, a line, a plane or the space.
class Span {
 public:
  /// Takes a direction of any length in, unless it follows from those that are in, or is 0.
  void add(const base::Vector3& v);
  /// The part of a vector at right angles to the span.
  base::Vector3 without(const base::Vector3& v) const;
  /// Whether a vector lies in the span but for round-off.
  bool contains(const base::Vector3& v) const;
  /// Whether a vector is at right angles to the span but for round-off.
  bool excludes(const base::Vector3& v) const;
  /// An orthonormal basis of what is at right angles to the span, of the rows of an orthogonal matrix as far as these
  /// are.
  std::vector<base::Vector3> complement(const base::Frame& rows) const;
  /// Whether it holds all directions.
  bool isSpace() const { return axes_.size() == 3; }

 private:
  std::vector<base::Vector3> axes_;  // orthonormal
};

}  // namespace harmos::scene
