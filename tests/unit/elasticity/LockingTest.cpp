#include <cmath>

#include <gtest/gtest.h>

#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/elasticity/Stress.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

constexpr double inner = 1.0, outer = 2.0, height = 0.2, pressure = 3.0, youngsModulus = 100.0;

/// A quarter of a thick cylinder in plane strain (3-D: no displacement along z) under internal pressure.
struct Cylinder {
  mesh::Mesh mesh;
  mesh::Piece piece;

  explicit Cylinder(mesh::ElementType type) {
    mesh::Box box;
    box.name = "wall";
    box.element = type;
    const bool solid = type == mesh::ElementType::hex8;
    box.upper = {1.0, 1.0, solid ? height : 0.0};
    box.cells = {8, 12, solid ? 1 : 0};
    mesh = mesh::boxes({box});
    for (base::Vector3& x : mesh.nodes) {
      const double r = inner + (outer - inner) * x[0], angle = std::acos(0.0) * x[1];
      x[0] = r * std::cos(angle);
      x[1] = r * std::sin(angle);
    }
    piece = mesh::makePiece(mesh, "wall", {"wall"});
  }

  double radius(std::size_t node) const { return std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]); }

  /// Mean radial displacement of the inner wall over the closed form.
  double relativeDisplacement(double nu, Formulation formulation) const {
    const int dimension = mesh.dimension;
    const auto stiffness =
        assembleStiffness(mesh, piece, Isotropic(youngsModulus, nu), formulation,
                          dimension == 3 ? Kinematics::threeDimensional : Kinematics::planeStrain, height);
    const std::size_t nodes = mesh.nodes.size();
    substructure::BoundaryTerm supports;
    supports.dimension = dimension;
    supports.diagonal.assign(nodes * static_cast<std::size_t>(dimension), 0.0);
    const double penalty = 1e8 * youngsModulus;
    std::vector<std::size_t> wall;
    for (std::size_t node = 0; node < nodes; ++node) {
      const auto first = node * static_cast<std::size_t>(dimension);
      if (std::abs(mesh.nodes[node][0]) < 1e-9) supports.diagonal[first] = penalty;
      if (std::abs(mesh.nodes[node][1]) < 1e-9) supports.diagonal[first + 1] = penalty;
      if (dimension == 3) supports.diagonal[first + 2] = penalty;
      if (std::abs(radius(node) - inner) < 1e-9) wall.push_back(node);
    }
    // Equal radial forces; the two edges of the quarter carry half. In 3-D two layers share them.
    base::Matrix force(static_cast<int>(nodes) * dimension, 1), u;
    const double total = pressure * inner * height * std::acos(0.0) / 12 / (dimension - 1);
    for (const std::size_t node : wall) {
      const base::Vector3& x = mesh.nodes[node];
      const bool edge = std::abs(x[0]) < 1e-9 || std::abs(x[1]) < 1e-9;
      for (int i = 0; i < 2; ++i) {
        force(static_cast<int>(node) * dimension + i, 0) = (edge ? 0.5 : 1.0) * total * x[i] / inner;
      }
    }
    substructure::SubstructureSolver(stiffness, supports, {}, "wall").solve(force, u);
    double mean = 0.0;
    for (const std::size_t node : wall) {
      const base::Vector3& x = mesh.nodes[node];
      const int first = static_cast<int>(node) * dimension;
      mean += (u(first, 0) * x[0] + u(first + 1, 0) * x[1]) / inner / static_cast<double>(wall.size());
    }
    const double exact = (1.0 + nu) * pressure * inner / youngsModulus / (outer * outer - inner * inner) *
                         ((1.0 - 2.0 * nu) * inner * inner + outer * outer);
    return mean / exact;
  }
};

class ThickCylinder : public testing::TestWithParam<mesh::ElementType> {};

// Lame's solution; 8 elements through the wall leave about 0.5 %.
TEST_P(ThickCylinder, doesNotLockWithBBar) {
  const Cylinder cylinder(GetParam());
  for (const double nu : {0.0, 0.3, 0.49, 0.4999, 0.49999}) {
    EXPECT_NEAR(cylinder.relativeDisplacement(nu, Formulation::bBar), 1.0, 0.01) << nu;
  }
}

TEST_P(ThickCylinder, locksWithFullIntegration) {
  const Cylinder cylinder(GetParam());
  EXPECT_NEAR(cylinder.relativeDisplacement(0.3, Formulation::fullIntegration), 1.0, 0.01);
  EXPECT_LT(cylinder.relativeDisplacement(0.49999, Formulation::fullIntegration), 0.7);
}

INSTANTIATE_TEST_SUITE_P(Elements, ThickCylinder, testing::Values(mesh::ElementType::quad4, mesh::ElementType::hex8),
                         [](const auto& type) { return std::string(mesh::exodusName(type.param)); });

}  // namespace
}  // namespace harmos::elasticity
