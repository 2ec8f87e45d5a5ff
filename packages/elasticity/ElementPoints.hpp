#pragma once

#include <functional>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/Material.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// A part and what makes stress of its displacements; refers to all, owns nothing.
struct ElasticPart {
  const mesh::Mesh& mesh;
  const mesh::Piece& piece;
  const Material& material;
  Formulation formulation = Formulation::fullIntegration;
  Kinematics kinematics = Kinematics::threeDimensional;
  double thickness = 1.0;  ///< [length], in the plane only
  /// Temperature over that of the stress-free state, nodes of the piece x columns [temperature]: of as many first
  /// columns of displacements. Null: none. The strain alpha T counts where the material has a thermal expansion.
  const base::Matrix* temperature = nullptr;
};

class ElementStrain;

/// At which points of an element.
enum class PointSet {
  stiffness,   ///< those of full integration
  sampling,    ///< where the stress of the finite elements is at its best: centres of tri3 and tet4, 2 Gauss points per
               ///< direction in quadrilaterals and hexahedra, the points of full integration elsewhere
  squares,     ///< the fewest that integrate squares of stresses which vary as displacements do, where elements are
               ///< not distorted
  integration  ///< the same in distorted elements too
};

/// The points of an element of a part; the arrays belong to the caller of the visitor, during the call only.
struct ElementPoints {
  int element = 0;                          ///< position in Piece::elements
  int nodes = 0;                            ///< of the element
  const int* node = nullptr;                ///< their local numbers in the piece
  int points = 0;                           ///< how many
  const double* value = nullptr;            ///< shape functions N_a [-]: points x nodes
  const base::Vector3* position = nullptr;  ///< of every point [length]
  const double* volume = nullptr;           ///< weight times Jacobian [length^3; in the plane times thickness]
  bool isConstant = false;                  ///< the stress is the same at all points
  const ElementStrain* strain = nullptr;    ///< of the element
  const double* temperature = nullptr;      ///< points x columns of ElasticPart::temperature [temperature]
  std::function<const double*()> stress;    ///< finds the [stress]: points x six components x columns
};

/// Visits the elements in their order, with what is known at their points. Their stress, in the order of components of
/// elementStress(), is found where the visitor asks for it: that of displacements, dofs x columns [length], and of the
/// temperature, as the formulation has it. In linear elements, whose strain is hardly more than constant, the
/// temperature is the mean over the element. Throws base::Error as elementStress(). Not collective.
void visitElements(const ElasticPart& part, PointSet points, const base::Matrix& displacements,
                   const std::function<void(const ElementPoints&)>& visit);
/// The same of a part at rest.
void visitElements(const ElasticPart& part, PointSet points, const std::function<void(const ElementPoints&)>& visit);

}  // namespace harmos::elasticity
