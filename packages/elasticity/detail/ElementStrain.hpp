#pragma once

#include <cstddef>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/base/Vector3.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/detail/ElementBasis.hpp>
#include <harmos/elasticity/detail/ElementIntegrals.hpp>
#include <harmos/elasticity/detail/StrainOperator.hpp>
#include <harmos/mesh/ReferenceElement.hpp>

namespace harmos::elasticity {

/// Strains of elements of one type and formulation at given points of the reference element.
class ElementStrain {
 public:
  /// `c` [stress]: under the kinematics. places: xi of the points.
  ElementStrain(mesh::ElementType type, Formulation formulation, Kinematics kinematics, const ElasticityMatrix& c,
                const std::vector<base::Vector3>& places);

  /// Looks at an element with these nodes [length]. False when it is turned inside out.
  bool set(const std::vector<base::Vector3>& nodes);
  /// Displaces them, columns x (components x nodes) [length].
  void displace(const base::Matrix& displacements);

  /// Shape functions N_a of the nodes at a point.
  const double* values(int point) const {
    return shape_.value.data() + static_cast<std::ptrdiff_t>(point) * shape_.nodes;
  }
  /// Determinant of the Jacobian at a point [length^dimension].
  double determinant(int point) const { return determinant_[point]; }
  /// Means of the N_a over the element, weighted by volume.
  std::vector<double> meanValues() const {
    std::vector<double> mean(shape_.nodes);
    for (int a = 0; a < shape_.nodes; ++a) mean[a] = integrals_.value[a] / integrals_.volume;
    return mean;
  }
  /// Adds volume B^t stress [force] to the forces of the nodes, components x nodes: what a stress at a point asks of
  /// them, B as in full integration.
  void addForces(int point, const Strain& stress, double volume, double* forces) const;
  /// Strain of all columns at a point: components xx, yy, zz, xy, yz, zx, shear doubled, x columns.
  void findStrain(int point, double* strain) const;

 private:
  bool integrateOver(bool withProduct);
  void findModes();
  /// Adds the strain that these gradients of the functions make of the displacements.
  void addStrain(const double* gradient, double factor, double* strain) const;

  ElementBasis basis_;
  StrainOperator operators_;
  Formulation formulation_;
  bool isAffine_;              // one Jacobian at all points
  double c_[3][3][3][3] = {};  // of components i, j and gradients k, l
  int dimension_;              // of the mesh
  int components_;             // of a displacement
  mesh::ShapeFunctions shape_;
  std::vector<base::Vector3> places_;
  ElementIntegrals integrals_;
  std::vector<double> determinant_;
  std::vector<double> gradient_;  // points x functions x gradients
  std::vector<base::Vector3> nodes_;
  base::Matrix values_;             // of nodes and modes, columns x (components x functions)
  std::vector<double> meanVolume_;  // strain of the volume in the mean over the element, of every column
};

}  // namespace harmos::elasticity
