#pragma once

#include <array>
#include <utility>
#include <vector>

#include <harmos/mesh/Depth.hpp>
#include <harmos/mortar/Reach.hpp>
#include <harmos/mortar/detail/Cell.hpp>

namespace harmos::mortar {

/// One number for each corner of a face; those that it does not have are 0.
using CornerVector = std::array<double, FaceShape::mostCorners>;
/// One number for each pair of corners.
using CornerMatrix = std::array<CornerVector, FaceShape::mostCorners>;

/// Integrals over the part that a face of the mortar side has in common with the other side, with its corner functions
/// N_p (linear or bilinear), the shape functions N_j of the nodes of both sides, and the normal n of its cells.
struct FaceCoupling {
  /// int N_p N_j dS [area] of a mesh node j.
  struct Column {
    int node = -1;
    CornerVector value{};
  };
  int face = -1;                                               // position in the list of faces of the mortar side
  int corners = 0;                                             // of that face
  double area = 0.0;                                           // of the common part
  CornerVector whole{};                                        // int N_p dS over all of the face [area]
  CornerMatrix mass{};                                         // int N_p N_q dS
  std::array<base::Vector3, FaceShape::mostCorners> normal{};  // int N_p n dS
  std::array<std::vector<Column>, 2> columns;                  // of the mortar side and of the other one, by node
  std::vector<int> facing;                                     // faces of the other side with a common part, ascending
};

/// The faces of one side and what they are replaced by.
struct SideCells {
  const std::vector<mesh::Face>& faces;
  std::vector<Cell> cells;
};

/// Integrates over the common refinement of both sides: cells are projected on the plane of the mortar side's cell,
/// clipped and cut into triangles. `pairs`: cells of the mortar side and of the other one, ascending. `points`:
/// coordinates of the mesh nodes [length]; `depth` multiplies lengths in 2-D. Faces without a common part
/// do not appear.
///
/// Exact where both faces are affine images of their parents. On others the integrand is no polynomial: the order grows
/// with the distortion, and what depends on the rule being one and the same (sums of rows, biorthogonality, linear
/// fields) holds to round-off nevertheless.
std::vector<FaceCoupling> coupleFaces(int dimension, const std::vector<base::Vector3>& points, const mesh::Depth& depth,
                                      const SideCells& mortar, const SideCells& other,
                                      const std::vector<std::pair<int, int>>& pairs, const Reach& reach);

}  // namespace harmos::mortar
