#pragma once

#include <harmos/base/Vector3.hpp>

namespace harmos::mesh {

/// What a node has of the faces around it, with their shape functions N [length^2; in 2-D length times depth].
///
/// On linear faces area is share, and normal is flux. On quadratic ones shares may be 0 (corners of triangles) or
/// negative (corners of quad8), so that they are right for loads only; areas are positive and add up to the same.
struct NodalWeight {
  double share = 0.0;      ///< int N dS
  base::Vector3 flux{};    ///< int N n dS, n outwards, whatever the projection
  double area = 0.0;       ///< share of the diagonal of the mass in its trace, times the area of the face
  base::Vector3 normal{};  ///< int N^2 n dS, scaled as area

  /// Adds those of another face.
  NodalWeight& operator+=(const NodalWeight& more) {
    share += more.share;
    flux = flux + more.flux;
    area += more.area;
    normal = normal + more.normal;
    return *this;
  }
  /// `factor` of it, normals times `orientation` besides.
  NodalWeight scaled(double factor, double orientation = 1.0) const {
    return {factor * share, factor * orientation * flux, factor * area, factor * orientation * normal};
  }
};

}  // namespace harmos::mesh
