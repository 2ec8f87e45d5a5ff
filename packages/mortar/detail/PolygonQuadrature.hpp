#pragma once

#include <vector>

#include <harmos/mortar/detail/ConvexPolygon.hpp>

namespace harmos::mortar {

/// A place on a plane with its share of the area.
struct QuadraturePoint {
  Flat place{};
  double weight = 0.0;  // [length^2], on a line [length]
};

/// Gauss points of a convex polygon, cut into triangles from its first corner, or of a segment. Exact for polynomials
/// of this degree. On a triangle Gauss' rule in the square that is collapsed to it (Stroud 1971). `points` is
/// overwritten.
void integratePolygon(const ConvexPolygon& polygon, int degree, std::vector<QuadraturePoint>& points);

}  // namespace harmos::mortar
