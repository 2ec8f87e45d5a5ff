#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <harmos/elasticity/Materials.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/mesh/Boxes.hpp>
#include <harmos/mesh/Skin.hpp>
#include <harmos/recovery/DualWeightedResidual.hpp>
#include <harmos/recovery/StressRecovery.hpp>

namespace harmos::recovery {
namespace {

using elasticity::ElasticPart;
using elasticity::Formulation;
using elasticity::Kinematics;
using mesh::ElementType;

constexpr double young = 1000.0, poisson = 0.25;

/// A box of one element type, its inner nodes moved a little, and a displacement of all its nodes.
struct Box {
  Box(ElementType type, const std::vector<int>& cells)
      : kinematics(mesh::dimensionOf(type) == 2 ? Kinematics::planeStress : Kinematics::threeDimensional),
        mesh(boxesOf(type, cells)),
        piece(mesh::makePiece(mesh, "box", {"box"})),
        material(young, poisson),
        boundary(piece.nodes.size(), false) {
    for (const mesh::Face& face : mesh::skin(mesh::Elements(mesh), piece.elements)) {
      for (const int node : face.nodes) boundary[mesh::localNode(piece, node)] = true;
    }
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      if (boundary[i]) continue;
      mesh.nodes[i][0] += 0.02 * std::sin(5.0 * static_cast<double>(i));
      mesh.nodes[i][1] += 0.02 * std::cos(3.0 * static_cast<double>(i));
    }
  }

  static mesh::Mesh boxesOf(ElementType type, const std::vector<int>& cells) {
    mesh::Box box;
    box.name = "box";
    box.element = type;
    box.upper = {1.0, 1.0, mesh::dimensionOf(type) == 2 ? 0.0 : 1.0};
    box.cells = {cells[0], cells[1], mesh::dimensionOf(type) == 2 ? 0 : cells[2]};
    return mesh::boxes({box});
  }

  ElasticPart part() const { return {mesh, piece, material, Formulation::fullIntegration, kinematics, 1.0}; }
  template <class Function>
  base::Matrix displaced(const Function& u) const {
    const int dimension = mesh.dimension;
    base::Matrix result(dimension * static_cast<int>(piece.nodes.size()), 1);
    for (std::size_t i = 0; i < piece.nodes.size(); ++i) {
      const base::Vector3 value = u(mesh.nodes[piece.nodes[i]]);
      for (int c = 0; c < dimension; ++c) result(dimension * static_cast<int>(i) + c, 0) = value[c];
    }
    return result;
  }

  Kinematics kinematics;
  mesh::Mesh mesh;
  mesh::Piece piece;
  elasticity::Isotropic material;
  std::vector<bool> boundary;
};

class Recovery : public ::testing::TestWithParam<ElementType> {};

// Of a constant stress every fit is exact, at every node and in all elements.
TEST_P(Recovery, KeepsConstantStress) {
  const Box box(GetParam(), {3, 2, 2});
  const base::Matrix u = box.displaced([](const base::Vector3& x) {
    return base::Vector3{1e-3 * x[0] + 2e-4 * x[1], -3e-4 * x[1] + 2e-4 * x[0], -2e-4 * x[2]};
  });
  const StressRecovery recovery(box.part(), box.boundary, u);
  const double* first = recovery.stress()[0];
  EXPECT_GT(std::abs(first[0]), 0.5);
  for (std::size_t node = 0; node < box.piece.nodes.size(); ++node) {
    for (int m = 0; m < 6; ++m) EXPECT_NEAR(first[6 * node + m], first[m], 1e-10);
  }
  const PartResidual residual =
      dualWeightedResidual(box.part(), u, {}, box.boundary, {}, std::vector<bool>(box.piece.nodes.size(), false));
  EXPECT_LT(residual.errorEnergy, 1e-20);
  EXPECT_GT(residual.energy, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Elements, Recovery,
                         ::testing::Values(ElementType::tri3, ElementType::quad4, ElementType::tet4,
                                           ElementType::pyramid5, ElementType::wedge6, ElementType::hex8),
                         [](const auto& test) { return std::string(mesh::exodusName(test.param)); });

// Pure bending: u = k x y, v = -k (x^2 + nu y^2) / 2 in plane stress has sigma_xx = E k y, which is linear, and the
// recovery finds it at every node, although the elements at the points of sampling only.
TEST(Recovery, FindsLinearStressFromItsBestPoints) {
  mesh::Box given;
  given.name = "box";
  given.element = ElementType::quad4;
  given.upper = {2.0, 1.0, 0.0};
  given.cells = {8, 8, 0};
  const mesh::Mesh mesh = mesh::boxes({given});
  const mesh::Piece piece = mesh::makePiece(mesh, "box", {"box"});
  const elasticity::Isotropic material(young, 0.0);
  base::Matrix u(2 * static_cast<int>(piece.nodes.size()), 1);
  constexpr double k = 1e-3;
  for (int i = 0; i < static_cast<int>(piece.nodes.size()); ++i) {
    const base::Vector3& x = mesh.nodes[i];
    u(2 * i, 0) = k * x[0] * x[1];
    u(2 * i + 1, 0) = -0.5 * k * x[0] * x[0];
  }
  const ElasticPart part{mesh, piece, material, Formulation::fullIntegration, Kinematics::planeStress, 1.0};
  const StressRecovery recovery(part, std::vector<bool>(piece.nodes.size(), false), u);
  for (int i = 0; i < static_cast<int>(piece.nodes.size()); ++i) {
    EXPECT_NEAR(recovery.stress()[0][6 * i], young * k * mesh.nodes[i][1], 1e-9 * young * k);
  }
}

// Work of the error: with the displacement as its own adjoint dJ is the energy of the error.
TEST(Recovery, OfTheSolutionItselfIsTheEnergyOfTheError) {
  const Box box(ElementType::hex8, {2, 3, 2});
  const base::Matrix u = box.displaced([](const base::Vector3& x) {
    return base::Vector3{1e-3 * x[0] * x[1], 5e-4 * x[1] * x[2], -1e-3 * x[0] * x[0]};
  });
  base::Matrix both(u.numRows(), 2);
  for (int column = 0; column < 2; ++column) std::copy_n(u[0], u.numRows(), both[column]);
  const PartResidual residual = dualWeightedResidual(box.part(), both, {{0, 0}}, box.boundary, {},
                                                     std::vector<bool>(box.piece.nodes.size(), false));
  EXPECT_GT(residual.errorEnergy, 0.0);
  EXPECT_NEAR(residual.change[0], residual.errorEnergy, 1e-12 * residual.errorEnergy);
  EXPECT_NEAR(residual.absolute[0], residual.errorEnergy, 1e-12 * residual.errorEnergy);
  EXPECT_NEAR(residual.uncorrected[0], residual.errorEnergy, 1e-12 * residual.errorEnergy);
}

// A response may have an adjoint for each of several solutions: here the same field, once as it is and once half as
// large.
TEST(Recovery, AddsWhatSolutionsBringToOneResponse) {
  const Box box(ElementType::hex8, {2, 3, 2});
  const base::Matrix u = box.displaced([](const base::Vector3& x) {
    return base::Vector3{1e-3 * x[0] * x[1], 5e-4 * x[1] * x[2], -1e-3 * x[0] * x[0]};
  });
  base::Matrix fields(u.numRows(), 5);
  for (int column = 0; column < 5; ++column) {
    for (int row = 0; row < u.numRows(); ++row) fields(row, column) = (column == 1 ? 0.5 : 1.0) * u(row, 0);
  }
  const PartResidual residual = dualWeightedResidual(box.part(), fields, {{0, 0}, {1, 1}, {1, 0}}, box.boundary, {},
                                                     std::vector<bool>(box.piece.nodes.size(), false));
  EXPECT_NEAR(residual.change[0], 1.5 * residual.errorEnergy, 1e-12 * residual.errorEnergy);
  EXPECT_NEAR(residual.change[1], 0.5 * residual.errorEnergy, 1e-12 * residual.errorEnergy);
  EXPECT_NEAR(residual.work[0], 1.5 * residual.energy, 1e-12 * residual.energy);
}

}  // namespace
}  // namespace harmos::recovery
