#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/Stiffness.hpp>

#include <gtest/gtest.h>

#include <Teuchos_LAPACK.hpp>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

class EveryElementStiffness : public testing::TestWithParam<Case> {};

TEST_P(EveryElementStiffness, isSymmetricToTheLastBit) {
  const Case given = GetParam();
  const Patch patch = Patch(given, 2).distort(0.05);
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, skewOrthotropic(given.dimension()),
                                           given.formulation, given.kinematics);
  const substructure::CrsView view = substructure::viewOf(*stiffness, "patch");
  base::Matrix dense(view.rows, view.rows);
  for (int row = 0; row < view.rows; ++row) {
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k)
      dense(row, view.columns[k]) = view.values[k];
  }
  for (int row = 0; row < view.rows; ++row) {
    for (int column = 0; column < row; ++column) ASSERT_EQ(dense(row, column), dense(column, row));
  }
}

TEST_P(EveryElementStiffness, onlyRigidMotionsHaveNoEnergy) {
  const Case given = GetParam();
  const Patch patch = Patch(given, 1).distort(0.05);
  const auto stiffness =
      assembleStiffness(patch.mesh, patch.piece, Isotropic(1.0, 0.3), given.formulation, given.kinematics);
  const substructure::CrsView view = substructure::viewOf(*stiffness, "patch");
  base::Matrix dense(view.rows, view.rows);
  for (int row = 0; row < view.rows; ++row) {
    for (std::size_t k = view.rowPointers[row]; k < view.rowPointers[row + 1]; ++k)
      dense(row, view.columns[k]) = view.values[k];
  }
  std::vector<double> eigenvalues(view.rows), work(8 * view.rows);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('N', 'U', view.rows, dense.values(), dense.stride(), eigenvalues.data(),
                                      work.data(), static_cast<int>(work.size()), &info);
  ASSERT_EQ(info, 0);
  const std::size_t rigid = given.dimension() == 3 ? 6 : 3;
  for (std::size_t i = 0; i < eigenvalues.size(); ++i) {
    if (i < rigid) {
      EXPECT_NEAR(eigenvalues[i], 0.0, 1e-13);
    } else {
      EXPECT_GT(eigenvalues[i], 1e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, EveryElementStiffness, testing::ValuesIn(everyCase()),
                         [](const auto& given) { return given.param.name(); });

constexpr Case hexahedra{mesh::ElementType::hex8, Kinematics::threeDimensional, Formulation::fullIntegration};
constexpr Case quadrilaterals{mesh::ElementType::quad4, Kinematics::planeStrain, Formulation::fullIntegration};

TEST(Stiffness, growsWithTheThickness) {
  const Patch patch(quadrilaterals, 2);
  const auto thin =
      assembleStiffness(patch.mesh, patch.piece, Isotropic(1.0, 0.3), Formulation::bBar, Kinematics::planeStrain, 1.0);
  const auto thick =
      assembleStiffness(patch.mesh, patch.piece, Isotropic(1.0, 0.3), Formulation::bBar, Kinematics::planeStrain, 4.0);
  EXPECT_DOUBLE_EQ(4.0 * substructure::viewOf(*thin, "").values[0], substructure::viewOf(*thick, "").values[0]);
}

TEST(Stiffness, bBarChangesNothingForConstantVolumeChange) {
  // One parallelepiped, bending apart, has constant gradients only for linear displacements: compare energies there.
  const Patch patch = Patch(hexahedra, 2).distort(0.05);
  const Isotropic material(1.0, 0.4);
  const auto full =
      assembleStiffness(patch.mesh, patch.piece, material, Formulation::fullIntegration, Kinematics::threeDimensional);
  const auto bBar =
      assembleStiffness(patch.mesh, patch.piece, material, Formulation::bBar, Kinematics::threeDimensional);
  const base::Matrix u = linearField(patch.mesh, {{1.0, 0.2, 0.0}, {0.0, 0.5, 0.0}, {0.3, 0.0, -0.4}});
  base::Matrix difference = product(*full, u);
  difference -= product(*bBar, u);
  EXPECT_LT(largest(difference), 1e-13);
  EXPECT_NE(substructure::viewOf(*full, "").values[0], substructure::viewOf(*bBar, "").values[0]);
}

TEST(Stiffness, takesPartsOfSeveralBlocks) {
  mesh::Box left, right;
  left.name = "left";
  right.name = "right";
  left.upper = {1.0, 1.0, 1.0};
  right.lower = {2.0, 0.0, 0.0};
  right.upper = {3.0, 1.0, 1.0};
  left.cells = right.cells = {2, 2, 2};
  right.element = mesh::ElementType::tet4;
  const mesh::Mesh mesh = mesh::boxes({left, right});
  const mesh::Piece both = mesh::makePiece(mesh, "both", {"left", "right"}),
                    second = mesh::makePiece(mesh, "second", {"right"});
  const auto stiffness = [&](const mesh::Piece& piece) {
    return assembleStiffness(mesh, piece, Isotropic(1.0, 0.3), Formulation::fullIntegration,
                             Kinematics::threeDimensional);
  };
  const auto whole = stiffness(both), piece = stiffness(second);
  const substructure::CrsView wholeView = substructure::viewOf(*whole, ""), partView = substructure::viewOf(*piece, "");
  const std::size_t offset = wholeView.rowPointers[wholeView.rows] - partView.rowPointers[partView.rows];
  for (std::size_t k = 0; k < partView.rowPointers[partView.rows]; ++k) {
    ASSERT_EQ(wholeView.values[offset + k], partView.values[k]);
  }
}

std::string messageOf(const Patch& patch, Formulation formulation, Kinematics kinematics) {
  try {
    assembleStiffness(patch.mesh, patch.piece, Isotropic(1.0, 0.3), formulation, kinematics);
  } catch (const base::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Stiffness, namesElementsThatAreInsideOutOrFlat) {
  Patch patch(hexahedra, 2);
  std::vector<int>& nodes = patch.mesh.blocks[0].connectivity;
  std::swap(nodes[8 * 5], nodes[8 * 5 + 4]);
  std::string message = messageOf(patch, Formulation::fullIntegration, Kinematics::threeDimensional);
  EXPECT_NE(message.find("part \"patch\", element 6 of the mesh (block \"box\")"), std::string::npos) << message;

  // Sums of shape functions times a coordinate are not quite zero everywhere.
  for (const double place : {0.0, 1.0, 3.0, 5.0, 1e-3, -1234.5}) {
    Patch line(quadrilaterals, 2), plane(hexahedra, 2);
    for (base::Vector3& x : line.mesh.nodes) x[1] = place;
    for (base::Vector3& x : plane.mesh.nodes) x[2] = place;
    message = messageOf(line, Formulation::fullIntegration, Kinematics::planeStress);
    EXPECT_NE(message.find("element 1 of the mesh (block \"box\")"), std::string::npos) << message;
    message = messageOf(plane, Formulation::fullIntegration, Kinematics::threeDimensional);
    EXPECT_NE(message.find("element 1 of the mesh (block \"box\")"), std::string::npos) << message;
  }
}

TEST(Stiffness, saysWhichMiddleNodeIsHowFarOutOfPlace) {
  Patch patch({mesh::ElementType::hex20, Kinematics::threeDimensional, Formulation::fullIntegration}, 1,
              {1.0, 1.0, 2.0});
  // The middle of the edge from corner 1 to 2, moved beyond a quarter of its length: the element is folded at corner 1,
  // but at no quadrature point.
  const int node = patch.mesh.blocks[0].connectivity[8];
  base::Vector3& place = patch.mesh.nodes[node];
  place[0] = 0.26;
  EXPECT_EQ(messageOf(patch, Formulation::fullIntegration, Kinematics::threeDimensional), "no error");
  place[0] = 0.2;
  const std::string message = messageOf(patch, Formulation::fullIntegration, Kinematics::threeDimensional);
  EXPECT_NE(
      message.find("element 1 of the mesh (block \"box\"): the element is folded: node " + std::to_string(node + 1) +
                   " of the mesh at (0.2, 0, 0) is 0.3 away from the middle of its edge, 0.3 of the length of "
                   "the edge."),
      std::string::npos)
      << message;
}

TEST(Stiffness, countsElementsThatCannotBeUsed) {
  Patch patch(hexahedra, 2);
  std::vector<int>& nodes = patch.mesh.blocks[0].connectivity;
  for (const int element : {2, 5, 7}) std::swap(nodes[8 * element], nodes[8 * element + 4]);
  const std::string message = messageOf(patch, Formulation::fullIntegration, Kinematics::threeDimensional);
  EXPECT_NE(message.find("element 3 of the mesh"), std::string::npos) << message;
  EXPECT_NE(message.find("The same is wrong with 2 more elements of the part."), std::string::npos) << message;
}

TEST(Stiffness, incompatibleModesNeedHexahedraOrQuadrilaterals) {
  const Patch wedges({mesh::ElementType::wedge6, Kinematics::threeDimensional, Formulation::fullIntegration}, 1);
  EXPECT_NE(messageOf(wedges, Formulation::incompatibleModes, Kinematics::threeDimensional).find("only HEX8 and QUAD4"),
            std::string::npos);
}

TEST(Stiffness, refusesBBarWhereItDoesNotHelp) {
  const Patch quadratic({mesh::ElementType::hex20, Kinematics::threeDimensional, Formulation::fullIntegration}, 1);
  EXPECT_NE(messageOf(quadratic, Formulation::bBar, Kinematics::threeDimensional).find("HEX20"), std::string::npos);
  const Patch tetrahedra({mesh::ElementType::tet4, Kinematics::threeDimensional, Formulation::bBar}, 1);
  EXPECT_NE(messageOf(tetrahedra, Formulation::bBar, Kinematics::threeDimensional).find("TET4"), std::string::npos);
  EXPECT_NE(messageOf(Patch(quadrilaterals, 1), Formulation::bBar, Kinematics::planeStress).find("plane stress"),
            std::string::npos);
}

TEST(Stiffness, refusesKinematicsOfOtherDimension) {
  EXPECT_NE(messageOf(Patch(hexahedra, 1), Formulation::fullIntegration, Kinematics::planeStrain).find("Plane Strain"),
            std::string::npos);
  EXPECT_NE(
      messageOf(Patch(quadrilaterals, 1), Formulation::fullIntegration, Kinematics::threeDimensional).find("QUAD4"),
      std::string::npos);
}

TEST(BodyForce, hasNoThirdComponentInThePlane) {
  const Patch patch(quadrilaterals, 1);
  const Isotropic material(1.0, 0.0);
  std::vector<double> forces(2 * patch.piece.nodes.size());
  const BodyForce body({patch.mesh, patch.piece, material, Formulation::fullIntegration, Kinematics::planeStrain});
  EXPECT_THROW(body.addTo(forces.data(), {{0.0, 0.0, 1.0}, {}}), base::Error);
}

}  // namespace
}  // namespace harmos::elasticity
