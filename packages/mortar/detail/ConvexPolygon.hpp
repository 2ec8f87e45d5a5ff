#pragma once

#include <array>

#include <harmos/mortar/detail/Plane.hpp>

namespace harmos::mortar {

/// A convex polygon in a plane, counter-clockwise; with two corners a segment of the first axis, ascending. Of at most
/// 16 corners, and without memory of its own on the heap: there are several for every pair of faces.
class ConvexPolygon {
 public:
  /// No corners.
  ConvexPolygon() = default;
  /// Corners of a convex polygon (or segment) in either orientation.
  template <typename Corners>
  explicit ConvexPolygon(const Corners& corners) {
    for (const Flat& corner : corners) add(corner);
    orient();
  }

  int corners() const { return count_; }
  const Flat& operator[](int i) const { return corner_[i]; }
  bool isSegment() const { return count_ == 2; }
  /// Area [length^2], length of a segment [length].
  double area() const;
  /// Twice the largest distance of a corner from the middle [length].
  double diameter() const;
  /// Mean of the corners, which lies inside.
  Flat middle() const;

  /// What two polygons, or two segments, have in common; none: no corners. By the half planes of the edges of `b`
  /// (Sutherland, Hodgman 1974, doi:10.1145/360767.360802).
  friend ConvexPolygon intersection(const ConvexPolygon& a, const ConvexPolygon& b);

 private:
  static constexpr int most = 16;  // a corner of each of two quadrilaterals, and as many again for round-off

  void add(const Flat& corner) {
    if (count_ < most) corner_[count_++] = corner;
  }
  void orient();
  double signedArea() const;

  std::array<Flat, most> corner_;
  int count_ = 0;
};

ConvexPolygon intersection(const ConvexPolygon& a, const ConvexPolygon& b);

}  // namespace harmos::mortar
