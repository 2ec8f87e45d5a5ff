#pragma once

#include <array>
#include <vector>

#include <harmos/elasticity/Kinematics.hpp>

namespace harmos::elasticity {

/// How strains follow from what a shape function contributes: strain_m is the sum of s g_k u_i over the terms of m,
/// gradients g_k times components u_i and a sign s; strains as in ElasticityMatrix.
///
/// The g_k [1/length] are the derivatives of N along x, y and, in space, z; in axisymmetry x is the radius, y the axis,
/// and the third one N / r, which makes the hoop strain zz and, with torsion, part of zx.
struct StrainOperator {
  /// sign g_gradient u_component is in the strain.
  struct Term {
    std::size_t strain;
    int gradient;
    int component;
    double sign = 1.0;
  };

  explicit StrainOperator(Kinematics kinematics);
  /// The strain of h[i][k], the sum over shape functions of u_i g_k.
  std::array<double, 6> strain(const double (&h)[3][3]) const {
    std::array<double, 6> result{};
    for (const Term& term : terms) result[term.strain] += term.sign * h[term.component][term.gradient];
    return result;
  }

  int gradients = 3;        ///< per shape function
  int components = 3;       ///< of a displacement
  std::vector<Term> terms;  ///< all of them
};

}  // namespace harmos::elasticity
