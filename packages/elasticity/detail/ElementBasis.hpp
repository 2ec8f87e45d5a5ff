#pragma once

#include <vector>

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/mesh/ReferenceElement.hpp>

namespace harmos::elasticity {

/// What integrals over elements of one type need of their reference element.
struct ElementBasis {
  /// The incompatible modes join where the formulation asks for them and the type has any.
  ElementBasis(mesh::ElementType type, Formulation formulation, Kinematics kinematics);

  mesh::ReferenceElement reference;
  mesh::ShapeFunctions atNodes;   ///< of quadratic elements, to find folds beside the quadrature points
  int modes = 0;                  ///< incompatible modes per displacement component
  mesh::ShapeFunctions atCentre;  ///< where there are modes
  /// dM_m/dxi_j of the modes M_m = 1 - xi_m^2: quadrature points x modes x dimension.
  std::vector<double> modeGradient;

  bool isRevolved = false;  ///< the element turns about the axis y

  /// Derivatives in space per function, and the value over the radius in axisymmetry.
  int gradients() const { return reference.dimension + (isRevolved ? 1 : 0); }
  /// Functions per displacement component: nodes and modes.
  int functions() const { return reference.nodes + modes; }
};

/// Whether elements of this type have incompatible modes: hex8 and quad4.
bool hasIncompatibleModes(mesh::ElementType type);

}  // namespace harmos::elasticity
