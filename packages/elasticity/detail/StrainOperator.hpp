#pragma once

#include <harmos/elasticity/Kinematics.hpp>

namespace harmos::elasticity {

/// How strains follow from what a shape function contributes: strain = sum over gradients g_k and components u_i of
/// coefficient[k][:][i] g_k u_i, strains as in ElasticityMatrix.
///
/// The g_k [1/length] are the derivatives of N along x, y and, in space, z; in axisymmetry x is the radius, y the axis,
/// and the third one N / r, which makes the hoop strain zz.
struct StrainOperator {
  explicit StrainOperator(Kinematics kinematics);

  int gradients = 3;                 ///< per shape function
  int components = 3;                ///< of a displacement
  double coefficient[3][6][3] = {};  ///< gradient, strain, component
};

}  // namespace harmos::elasticity
