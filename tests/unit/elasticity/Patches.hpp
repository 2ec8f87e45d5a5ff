#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/detail/Orthotropic.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Piece.hpp>
#include <harmos/substructure/CrsMatrix.hpp>

namespace harmos::elasticity {

/// An element type with kinematics and formulation that suit it.
struct Case {
  mesh::ElementType type;
  Kinematics kinematics;
  Formulation formulation;

  int dimension() const { return dimensionOf(kinematics); }
  std::string name() const {
    std::string text = std::string(mesh::exodusName(type)) + kinematicsNames()[static_cast<std::size_t>(kinematics)] +
                       formulationNames()[static_cast<std::size_t>(formulation)];
    std::string letters;
    for (const char c : text) {
      if (std::isalnum(static_cast<unsigned char>(c))) letters += c;
    }
    return letters;
  }
};

inline std::vector<Case> everyCase() {
  using Type = mesh::ElementType;
  std::vector<Case> cases;
  for (const Type type : {Type::tet4, Type::pyramid5, Type::wedge6, Type::hex8}) {
    cases.push_back({type, Kinematics::threeDimensional, Formulation::fullIntegration});
    if (type != Type::tet4) cases.push_back({type, Kinematics::threeDimensional, Formulation::bBar});
  }
  for (const Type type : {Type::tet10, Type::wedge15, Type::hex20, Type::hex27}) {
    cases.push_back({type, Kinematics::threeDimensional, Formulation::fullIntegration});
  }
  cases.push_back({Type::hex8, Kinematics::threeDimensional, Formulation::incompatibleModes});
  cases.push_back({Type::quad4, Kinematics::planeStrain, Formulation::incompatibleModes});
  cases.push_back({Type::quad4, Kinematics::planeStress, Formulation::incompatibleModes});
  for (const Type type : {Type::tri3, Type::quad4, Type::tri6, Type::quad8, Type::quad9}) {
    cases.push_back({type, Kinematics::planeStrain, Formulation::fullIntegration});
    cases.push_back({type, Kinematics::planeStress, Formulation::fullIntegration});
  }
  cases.push_back({Type::quad4, Kinematics::planeStrain, Formulation::bBar});
  return cases;
}

/// A box of the element type in block "box", 1 x 0.8 x 1.2, and the part that it is.
struct Patch {
  mesh::Mesh mesh;
  mesh::Piece piece;
  std::vector<bool> interior;  // per node

  Patch(const Case& given, int cells, const base::Vector3& extent = {1.0, 0.8, 1.2})
      : mesh(boxOf(given, cells, extent)), piece(mesh::makePiece(mesh, "patch", {"box"})) {
    for (const base::Vector3& x : mesh.nodes) {
      bool inside = true;
      for (int i = 0; i < given.dimension(); ++i) {
        inside = inside && x[i] > 1e-9 * extent[i] && x[i] < (1.0 - 1e-9) * extent[i];
      }
      interior.push_back(inside);
    }
  }

  /// Moves every node by up to `amplitude` in every direction, so that edges of quadratic elements are curved.
  Patch& distort(double amplitude) {
    if (mesh::isQuadratic(mesh.blocks[0].type)) amplitude *= 0.35;  // more would fold elements at their corners
    double phase = 0.3;
    for (base::Vector3& x : mesh.nodes) {
      for (int i = 0; i < mesh.dimension; ++i) x[i] += amplitude * std::sin(phase += 1.7);
    }
    return *this;
  }

  static mesh::Mesh boxOf(const Case& given, int cells, const base::Vector3& extent) {
    mesh::Box box;
    box.name = "box";
    box.upper = extent;
    box.cells = {cells, cells, cells};
    if (given.dimension() == 2) box.upper[2] = box.cells[2] = 0;
    box.element = given.type;
    return mesh::boxes({box});
  }
};

/// Fibre material whose axes fit no coordinate plane in 3-D and turn about z in 2-D.
inline Orthotropic skewOrthotropic(int dimension) {
  Orthotropic::Constants c;
  c.youngsModulus = {140.0, 10.0, 25.0};
  c.poissonsRatio = {0.3, 0.2, 0.25};
  c.shearModulus = {5.0, 3.5, 4.0};
  c.axis1 = {1.0, 0.5, dimension == 3 ? -0.7 : 0.0};
  c.axis2 = {-0.2, 1.0, dimension == 3 ? 0.4 : 0.0};
  return Orthotropic(c);
}

/// Displacements u_i = sum_k gradient[i][k] x_k + offset.
inline base::Matrix linearField(const mesh::Mesh& mesh, const double (&gradient)[3][3], double offset = 0.0) {
  const int dimension = mesh.dimension;
  base::Matrix u(dimension * static_cast<int>(mesh.nodes.size()), 1);
  for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
    for (int i = 0; i < dimension; ++i) {
      u(dimension * node + i, 0) = offset;
      for (int k = 0; k < dimension; ++k) {
        u(dimension * node + i, 0) += gradient[i][k] * mesh.nodes[node][k];
      }
    }
  }
  return u;
}

inline base::Matrix product(const base::CrsMatrix& matrix, const base::Matrix& x) {
  const substructure::CrsView view = substructure::viewOf(matrix, "test");
  base::Matrix result(x.numRows(), x.numCols());
  for (int j = 0; j < x.numCols(); ++j) {
    for (int row = 0; row < view.rows; ++row) {
      for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k) {
        result(row, j) += view.values[k] * x(view.columns[k], j);
      }
    }
  }
  return result;
}

/// Largest absolute entry.
inline double largest(const base::Matrix& matrix) {
  double value = 0.0;
  for (int j = 0; j < matrix.numCols(); ++j) {
    for (int i = 0; i < matrix.numRows(); ++i) value = std::max(value, std::abs(matrix(i, j)));
  }
  return value;
}

}  // namespace harmos::elasticity
