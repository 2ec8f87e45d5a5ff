#pragma once

#include <array>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Material.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// Mean stress of every element of a part [stress], tension positive, from nodal displacements [length]
/// (dofs x columns), in the global axes.
///
/// Row 6 e + c of the result is component c = xx, yy, zz, xy, yz, zx of the element Piece::elements[e]; same columns as
/// the displacements. The mean is that of the stress of all formulations. In plane strain zz is the stress that keeps
/// eps_zz = 0, in plane stress zz, yz and zx are 0. Throws base::Error as assembleStiffness does, but for the
/// formulation, and when the displacements have other rows than the part has dofs. Not collective.
///
/// `temperature`: as ElasticPart::temperature, null: none.
base::Matrix elementStress(const mesh::Mesh& mesh, const mesh::Piece& piece, const Material& material,
                           Kinematics kinematics, const base::Matrix& displacements,
                           const base::Matrix* temperature = nullptr);

/// von Mises stress sqrt(3/2 s:s) [stress], s the deviator, of six components [stress] in the order of elementStress().
double vonMises(const double* stress);

/// Principal stresses [stress] of the same six components, the largest first.
std::array<double, 3> principalStresses(const double* stress);

}  // namespace harmos::elasticity
