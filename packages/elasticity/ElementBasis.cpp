#include <harmos/elasticity/detail/ElementBasis.hpp>

namespace harmos::elasticity {

bool hasIncompatibleModes(mesh::ElementType type) {
  return type == mesh::ElementType::hex8 || type == mesh::ElementType::quad4;
}

ElementBasis::ElementBasis(mesh::ElementType type, Formulation formulation, Kinematics kinematics)
    : reference(mesh::referenceElement(type)), isRevolved(isAxisymmetric(kinematics)) {
  if (mesh::isQuadratic(type)) atNodes = mesh::shapeFunctions(type, mesh::nodePlaces(type));
  if (formulation != Formulation::incompatibleModes || !hasIncompatibleModes(type)) return;
  modes = reference.dimension;
  atCentre = mesh::shapeFunctions(type, {base::Vector3{}});
  for (const base::Vector3& xi : reference.place) {
    for (int m = 0; m < modes; ++m) {
      for (int j = 0; j < reference.dimension; ++j) modeGradient.push_back(j == m ? -2.0 * xi[m] : 0.0);
    }
  }
}

}  // namespace harmos::elasticity
