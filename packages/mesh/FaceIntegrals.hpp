#pragma once

#include <optional>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Integrals over one face (edge in 2-D) with its linear or bilinear shape functions N, exact on plane faces, by 2 x 2
/// Gauss points on warped quadrilaterals. One entry per corner; n is the unit normal out of the element.
struct FaceIntegrals {
  std::vector<double> area;               // int N_i dS [length^2; in 2-D length times thickness]
  std::vector<base::Vector3> normal;      // int N_i n dS [as area], outwards, whatever the projection
  std::vector<std::vector<double>> mass;  // int N_i N_j dS [as area]; row sums are area
};

/// Integrates over the face with the given corners: 2 (an edge in the plane, times `thickness`), 3 or 4 points
/// [length], counter-clockwise seen from outside. With a unit vector `projection` dS of area and mass is the area seen
/// along it. The number of corners is not checked.
FaceIntegrals integrateFace(const std::vector<base::Vector3>& corners, double thickness,
                            const std::optional<base::Vector3>& projection = std::nullopt);

}  // namespace harmos::mesh
