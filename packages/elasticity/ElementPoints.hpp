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

/// A point of an element of a part; the arrays belong to the caller of the visitor, during the call only.
struct ElementPoint {
  int element = 0;                        ///< position in Piece::elements
  int nodes = 0;                          ///< of the element
  const int* node = nullptr;              ///< their local numbers in the piece
  const double* value = nullptr;          ///< shape functions N_a [-]
  base::Vector3 position{};               ///< [length]
  double volume = 0.0;                    ///< weight times Jacobian [length^3; in the plane times thickness]
  const ElementStrain* strain = nullptr;  ///< of the element
  int number = 0;                         ///< of the point in the element
  const double* temperature = nullptr;    ///< of every column of ElasticPart::temperature [temperature]
  const double* stress = nullptr;  ///< [stress] of every column, six components each in the order of elementStress()
};

/// Visits the points of all elements in their order, with the stress of the displacements there (dofs x columns
/// [length]) and of the temperature, as the formulation has it. In linear elements, whose strain is hardly more than
/// constant, the temperature is the mean over the element. Throws base::Error as elementStress(). Not collective.
void forEachPoint(const ElasticPart& part, PointSet points, const base::Matrix& displacements,
                  const std::function<void(const ElementPoint&)>& visit);

}  // namespace harmos::elasticity
