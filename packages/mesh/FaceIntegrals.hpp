#pragma once

#include <optional>
#include <vector>

#include <harmos/mesh/Depth.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/NodalWeight.hpp>

namespace harmos::mesh {

/// Integrals over one face (edge in 2-D) with its shape functions N, exact on plane faces, by 2 x 2 Gauss points on
/// warped quadrilaterals, by 6 points on triangles and 3 per direction on lines and quadrilaterals that are quadratic.
/// One entry per node. Areas of quadratic faces as in Hinton, Rock, Zienkiewicz, Earthquake Engng Struct. Dyn. 4
/// (1976), 245-249.
struct FaceIntegrals {
  std::vector<NodalWeight> weight;        // one per node
  std::vector<std::vector<double>> mass;  // int N_i N_j dS [as weights]; row sums are shares; may be left out
};

/// Integrates over the face with nodes at these places [length] in the order of sideNodes(): in a mesh of 2 dimensions
/// an edge of 2 or 3 nodes, times `depth`; of 3 dimensions 3, 4, 6, 8 or 9. With a unit vector `projection` dS of
/// share, area and mass is the area seen along it. On the axis of revolution a flux has no radial part. The number of
/// nodes is not checked.
FaceIntegrals integrateFace(int dimension, const std::vector<base::Vector3>& nodes, const Depth& depth,
                            const std::optional<base::Vector3>& projection = std::nullopt);

}  // namespace harmos::mesh
