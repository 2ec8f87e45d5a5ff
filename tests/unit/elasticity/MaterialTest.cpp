#include <harmos/elasticity/Materials.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/elasticity/detail/Orthotropic.hpp>

namespace harmos::elasticity {
namespace {

Orthotropic::Constants isotropicConstants(double e, double nu) {
  Orthotropic::Constants c;
  c.youngsModulus = {e, e, e};
  c.poissonsRatio = {nu, nu, nu};
  c.shearModulus = {e / (2.0 + 2.0 * nu), e / (2.0 + 2.0 * nu), e / (2.0 + 2.0 * nu)};
  return c;
}

void expectEqual(const ElasticityMatrix& a, const ElasticityMatrix& b) {
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(a[m][n], b[m][n], 1e-12 * std::abs(b[0][0])) << m << " " << n;
  }
}

TEST(Orthotropic, isIsotropicWhenItsConstantsAre) {
  Orthotropic::Constants c = isotropicConstants(200.0, 0.3);
  expectEqual(Orthotropic(c).elasticity(), Isotropic(200.0, 0.3).elasticity());
  c.axis1 = {1.0, 2.0, 3.0};
  c.axis2 = {0.0, -1.0, 1.0};
  expectEqual(Orthotropic(c).elasticity(), Isotropic(200.0, 0.3).elasticity());
}

Orthotropic::Constants wood() {
  Orthotropic::Constants c;
  c.youngsModulus = {12.0, 0.9, 0.5};
  c.poissonsRatio = {0.37, 0.43, 0.42};
  c.shearModulus = {0.8, 0.06, 0.7};
  return c;
}

TEST(Orthotropic, hasItsModuliAlongItsAxes) {
  const ElasticityMatrix c = Orthotropic(wood()).elasticity();
  // Uniaxial tension along 1: eps = (1, -nu12, -nu13)/E1.
  const double strain[3] = {1.0 / 12.0, -0.37 / 12.0, -0.42 / 12.0};
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_NEAR(c[m][0] * strain[0] + c[m][1] * strain[1] + c[m][2] * strain[2], m == 0 ? 1.0 : 0.0, 1e-12);
  }
  EXPECT_NEAR(c[3][3], 0.8, 1e-15);   // 12 -> xy
  EXPECT_NEAR(c[4][4], 0.06, 1e-15);  // 23 -> yz
  EXPECT_NEAR(c[5][5], 0.7, 1e-15);   // 13 -> zx
}

TEST(Orthotropic, turnsWithItsAxes) {
  Orthotropic::Constants turned = wood();  // x -> y -> z -> x
  turned.axis1 = {0.0, 2.0, 0.0};
  turned.axis2 = {0.0, 1.0, 5.0};  // made orthogonal: z
  const ElasticityMatrix c = Orthotropic(wood()).elasticity(), t = Orthotropic(turned).elasticity();
  constexpr std::size_t image[6] = {1, 2, 0, 4, 5, 3};
  for (std::size_t m = 0; m < 6; ++m) {
    for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(t[image[m]][image[n]], c[m][n], 1e-12);
  }
}

TEST(Orthotropic, keepsItsEnergyWhenAxesAndStrainTurnTogether) {
  const double angle = 0.4, cosine = std::cos(angle), sine = std::sin(angle);
  Orthotropic::Constants turned = wood();
  turned.axis1 = {cosine, sine, 0.0};
  turned.axis2 = {-sine, cosine, 0.0};
  const double exx = 0.3, eyy = -0.2, gxy = 0.5;
  const double strain[3] = {exx, eyy, gxy};
  const double rotated[3] = {cosine * cosine * exx + sine * sine * eyy - sine * cosine * gxy,
                             sine * sine * exx + cosine * cosine * eyy + sine * cosine * gxy,
                             2.0 * sine * cosine * (exx - eyy) + (cosine * cosine - sine * sine) * gxy};
  const auto energy = [](const ElasticityMatrix& c, const double(&e)[3]) {
    constexpr std::size_t plane[3] = {0, 1, 3};
    double sum = 0.0;
    for (std::size_t m = 0; m < 3; ++m) {
      for (std::size_t n = 0; n < 3; ++n) sum += e[m] * c[plane[m]][plane[n]] * e[n];
    }
    return sum;
  };
  EXPECT_NEAR(energy(Orthotropic(turned).elasticity(), rotated), energy(Orthotropic(wood()).elasticity(), strain),
              1e-12);
}

std::string messageOf(const Orthotropic::Constants& constants) {
  try {
    Orthotropic material(constants);
  } catch (const base::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Orthotropic, refusesNegativeEnergyAndSaysWhy) {
  Orthotropic::Constants c = wood();
  c.poissonsRatio[0] = 3.7;  // limit sqrt(12/0.9) = 3.65
  EXPECT_NE(messageOf(c).find("Poisson's Ratio 12"), std::string::npos) << messageOf(c);
  c = isotropicConstants(1.0, 0.51);  // each pair is allowed, all three together are not
  EXPECT_NE(messageOf(c).find("together"), std::string::npos) << messageOf(c);
  c = wood();
  c.axis2 = c.axis1;
  EXPECT_NE(messageOf(c).find("parallel"), std::string::npos) << messageOf(c);
  c = wood();
  c.shearModulus[1] = 0.0;
  EXPECT_NE(messageOf(c).find("above 0"), std::string::npos) << messageOf(c);
}

TEST(Isotropic, refusesConstantsOutsideItsRange) {
  EXPECT_NO_THROW(Isotropic(1e-6, -0.99));
  EXPECT_NO_THROW(Isotropic(1e12, 0.49999));
  EXPECT_THROW(Isotropic(0.0, 0.3), base::Error);
  EXPECT_THROW(Isotropic(1.0, 0.5), base::Error);
  EXPECT_THROW(Isotropic(1.0, -1.0), base::Error);
  EXPECT_THROW(Isotropic(1.0, 0.4999999999), base::Error);
  EXPECT_THROW(Isotropic(1.0, -0.9999999999), base::Error);
  EXPECT_THROW(Isotropic(std::nan(""), 0.3), base::Error);
}

TEST(PlaneStress, leavesYoungsModulusInTension) {
  const ElasticityMatrix c = reduced(Isotropic(70.0, 0.3).elasticity(), Kinematics::planeStress);
  EXPECT_NEAR(c[0][0], 70.0 / (1.0 - 0.09), 1e-12);
  EXPECT_NEAR(c[0][1], 0.3 * 70.0 / (1.0 - 0.09), 1e-12);
  EXPECT_NEAR(c[3][3], 70.0 / 2.6, 1e-12);
  for (std::size_t m = 0; m < 6; ++m) {
    for (const std::size_t gone : {2U, 4U, 5U}) EXPECT_EQ(c[m][gone], 0.0);
  }
}

TEST(Materials, areBuiltFromTheirParameters) {
  const MaterialRegistry materials = builtInMaterials();
  input::Parameters steel("steel");
  steel.set("Type", std::string("Isotropic")).set("Young's Modulus", 210e3).set("Poisson's Ratio", 0.3);
  expectEqual(materials.create(steel)->elasticity(), Isotropic(210e3, 0.3).elasticity());
  input::Parameters ply("ply");
  ply.set("Type", std::string("Orthotropic"));
  const Orthotropic::Constants c = wood();
  for (std::size_t i = 0; i < 3; ++i) {
    constexpr const char* pairs[3] = {"12", "23", "13"};
    ply.set("Young's Modulus " + std::to_string(i + 1), c.youngsModulus[i]);
    ply.set(std::string("Poisson's Ratio ") + pairs[i], c.poissonsRatio[i]);
    ply.set(std::string("Shear Modulus ") + pairs[i], c.shearModulus[i]);
  }
  expectEqual(materials.create(ply)->elasticity(), Orthotropic(c).elasticity());
  ply.set("Axis 1", std::vector<double>{1.0, 0.0});
  EXPECT_THROW(materials.create(ply), base::Error);
  EXPECT_EQ(materials.forms().size(), 2U);
}

TEST(Kinematics, areNamed) {
  EXPECT_EQ(kinematicsNamed("Plane Stress"), Kinematics::planeStress);
  EXPECT_EQ(formulationNamed("B-Bar"), Formulation::bBar);
  EXPECT_THROW(kinematicsNamed("plain strain"), base::Error);
}

}  // namespace
}  // namespace harmos::elasticity
