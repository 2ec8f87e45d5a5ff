#pragma once

#include <array>
#include <vector>

#include <harmos/mesh/Skin.hpp>
#include <harmos/mortar/detail/ConvexPolygon.hpp>
#include <harmos/mortar/detail/FaceShape.hpp>

namespace harmos::mortar {

/// A flat, convex part of a face, by which the geometry of faces is replaced: the face itself where it is linear or has
/// straight edges, else one of its parts between nodes. A warped quadrilateral is seen along its mean normal. Faces
/// without area have no cells.
struct Cell {
  int face = -1;                                             // position in the list of faces
  int count = 0;                                             // of corners: 2 to 4
  std::array<base::Vector3, FaceShape::mostCorners> corner;  // [length], counter-clockwise seen from outside
  base::Vector3 centre{};                                    // [length]
  base::Vector3 normal{};                                    // unit, out of the part
  double area = 0.0;                                         // [length^2], in 2-D [length]
  double size = 0.0;                                         // of the longest edge [length]

  /// The cell as it is seen along the normal of a plane.
  ConvexPolygon on(const Plane& plane) const;
};

/// The cells of faces; `points`: coordinates of the mesh nodes [length].
std::vector<Cell> cellsOf(int dimension, const std::vector<base::Vector3>& points,
                          const std::vector<mesh::Face>& faces);

}  // namespace harmos::mortar
