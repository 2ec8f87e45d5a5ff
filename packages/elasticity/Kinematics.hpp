#pragma once

#include <string>
#include <vector>

#include <harmos/elasticity/Material.hpp>

namespace harmos::elasticity {

/// How strains follow from displacements: in space, in the plane with eps_zz = 0, in the plane with sigma_zz = 0, or in
/// a half plane that turns about the axis y, with the radius x >= 0 and eps_zz = u_x / x around the hoop, without or
/// with torsion, which adds the displacement u_z around the hoop: gamma_zx = du_z/dx - u_z / x, gamma_yz = du_z/dy.
/// Stiffness and forces are then those of the whole circle.
enum class Kinematics { threeDimensional, planeStrain, planeStress, axisymmetric, axisymmetricWithTorsion };

/// Names for input: 3-D, Plane Strain, Plane Stress, Axisymmetric, Axisymmetric With Torsion.
const std::vector<std::string>& kinematicsNames();
/// The kinematics of this name. Throws base::Error (input) for any other name.
Kinematics kinematicsNamed(const std::string& name);

/// How displacements become strains: as they are; with the volume change as its mean over the element (no locking as nu
/// approaches 0.5); or with incompatible modes besides (elements that bend without shear, and hardly lock either).
enum class Formulation { fullIntegration, bBar, incompatibleModes };

/// Names for input: Full Integration, B-Bar, Incompatible Modes.
const std::vector<std::string>& formulationNames();
/// The formulation of this name. Throws base::Error (input) for any other name.
Formulation formulationNamed(const std::string& name);

/// Whether the plane turns about the axis y.
inline bool isAxisymmetric(Kinematics kinematics) {
  return kinematics == Kinematics::axisymmetric || kinematics == Kinematics::axisymmetricWithTorsion;
}

/// Dimensions of the mesh: 3, or 2 in the plane.
inline int dimensionOf(Kinematics kinematics) {
  return kinematics == Kinematics::threeDimensional ? 3 : 2;
}

/// Components of a displacement: those of the mesh, and with torsion the one around the hoop.
inline int componentsOf(Kinematics kinematics) {
  return kinematics == Kinematics::axisymmetricWithTorsion ? 3 : dimensionOf(kinematics);
}

/// Components of stress that do work on the strains of the kinematics, in the order of ElasticityMatrix.
std::vector<std::size_t> workingComponents(Kinematics kinematics);

/// Stress from strain under the kinematics, C [stress], components as in ElasticityMatrix: for plane stress zz, yz and
/// zx are eliminated (their rows and columns are zero); otherwise the matrix itself.
ElasticityMatrix reduced(const ElasticityMatrix& elasticity, Kinematics kinematics);

}  // namespace harmos::elasticity
