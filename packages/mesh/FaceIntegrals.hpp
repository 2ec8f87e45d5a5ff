#pragma once

#include <optional>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Integrals over one face (edge in 2-D) with its linear or bilinear shape functions N, exact on plane faces, by 2 x 2
/// Gauss points on warped quadrilaterals.
struct FaceIntegrals {
  std::vector<double> area;               // int N_i dS [length^2]
  std::vector<base::Vector3> normal;      // int N_i n dS [length^2], outwards
  std::vector<std::vector<double>> mass;  // int N_i N_j dS [length^2]; row sums are area
};

/// `corners` are 2 (times `thickness`), 3 or 4 points. With a unit vector `projection` dS is the area seen along it.
FaceIntegrals integrateFace(const std::vector<base::Vector3>& corners, double thickness,
                            const std::optional<base::Vector3>& projection = std::nullopt);

}  // namespace harmos::mesh
