#include <harmos/elasticity/Stress.hpp>

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

constexpr Case quadrilaterals{mesh::ElementType::quad4, Kinematics::planeStrain, Formulation::fullIntegration};

TEST(ElementStress, keepsThicknessInPlaneStrain) {
  const Patch patch(quadrilaterals, 2);
  const base::Matrix u = linearField(patch.mesh, {{1e-3, 0.0, 0.0}, {0.0, 2e-3, 0.0}, {0.0, 0.0, 0.0}});
  const base::Matrix strain = elementStress(patch.mesh, patch.piece, Isotropic(100.0, 0.3), Kinematics::planeStrain, u);
  EXPECT_NEAR(strain(2, 0), 0.3 * (strain(0, 0) + strain(1, 0)), 1e-14);
  const base::Matrix stress = elementStress(patch.mesh, patch.piece, Isotropic(100.0, 0.3), Kinematics::planeStress, u);
  EXPECT_EQ(stress(2, 0), 0.0);
  EXPECT_NEAR(stress(0, 0), 100.0 / 0.91 * (1e-3 + 0.3 * 2e-3), 1e-14);
}

TEST(ElementStress, takesColumnsOneByOne) {
  const Patch patch = Patch(quadrilaterals, 2).distort(0.05);
  const base::Matrix u = linearField(patch.mesh, {{1e-3, 5e-4, 0.0}, {0.0, 2e-3, 0.0}, {0.0, 0.0, 0.0}});
  base::Matrix two(u.numRows(), 2);
  for (int i = 0; i < u.numRows(); ++i) {
    two(i, 0) = u(i, 0);
    two(i, 1) = -2.0 * u(i, 0);
  }
  const base::Matrix stress =
      elementStress(patch.mesh, patch.piece, Isotropic(100.0, 0.3), Kinematics::planeStrain, two);
  for (int i = 0; i < stress.numRows(); ++i) EXPECT_DOUBLE_EQ(stress(i, 1), -2.0 * stress(i, 0));
}

TEST(ElementStress, refusesDisplacementsOfOtherSize) {
  const Patch patch(quadrilaterals, 1);
  EXPECT_THROW(elementStress(patch.mesh, patch.piece, Isotropic(1.0, 0.3), Kinematics::planeStrain, base::Matrix(7, 1)),
               base::Error);
}

TEST(VonMises, isTheTensionThatYieldsAlike) {
  const double tension[6] = {0.0, -5.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(vonMises(tension), 5.0);
  const double pressure[6] = {3.0, 3.0, 3.0, 0.0, 0.0, 0.0};
  EXPECT_DOUBLE_EQ(vonMises(pressure), 0.0);
  const double shear[6] = {0.0, 0.0, 0.0, 1.0, 2.0, -2.0};
  EXPECT_DOUBLE_EQ(vonMises(shear), std::sqrt(27.0));
}

TEST(PrincipalStresses, AreTheEigenvaluesInTheirOrder) {
  const auto expectNear = [](const double* stress, const std::array<double, 3>& expected) {
    const std::array<double, 3> principal = principalStresses(stress);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(principal[i], expected[i], 1e-7) << i;
  };
  const double diagonal[6] = {-5.0, 2.0, 1.0, 0.0, 0.0, 0.0};
  expectNear(diagonal, {2.0, 1.0, -5.0});
  const double pressure[6] = {-3.0, -3.0, -3.0, 0.0, 0.0, 0.0};
  expectNear(pressure, {-3.0, -3.0, -3.0});
  const double shear[6] = {0.0, 0.0, 0.0, 0.0, 4.0, 0.0};
  expectNear(shear, {4.0, 0.0, -4.0});
  // Two equal ones, turned: 1 + 3 v v^t with v = (2, 1, 2) / 3.
  const double turned[6] = {1.0 + 4.0 / 3.0, 1.0 + 1.0 / 3.0, 1.0 + 4.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0, 4.0 / 3.0};
  expectNear(turned, {4.0, 1.0, 1.0});
  // All different: invariants instead of values.
  const double any[6] = {3.0, -1.0, 2.0, 0.5, -2.0, 1.5};
  const auto p = principalStresses(any);
  EXPECT_NEAR(p[0] + p[1] + p[2], 4.0, 1e-12);
  EXPECT_NEAR(p[0] * p[1] * p[2], -6.0 + 2.0 * 0.5 * -2.0 * 1.5 - 3.0 * 4.0 + 1.0 * 2.25 - 2.0 * 0.25, 1e-12);
  EXPECT_TRUE(p[0] >= p[1] && p[1] >= p[2]);
}

}  // namespace
}  // namespace harmos::elasticity
