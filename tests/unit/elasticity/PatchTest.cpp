#include <gtest/gtest.h>

#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/elasticity/Stress.hpp>
#include <harmos/elasticity/ThermalLoad.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

constexpr double gradient[3][3] = {{1e-3, 4e-4, -7e-4}, {-2e-4, 6e-4, 3e-4}, {5e-4, -9e-4, -8e-4}};

class EveryElement : public testing::TestWithParam<Case> {};

/// A linear displacement of a distorted mesh leaves interior nodes without force and gives every element the same
/// stress.
void passPatchTest(const Case& given, const Material& material) {
  const Patch patch = Patch(given, 3).distort(0.04);
  const base::Matrix u = linearField(patch.mesh, gradient, 0.2);
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, material, given.formulation, given.kinematics, 0.7);
  const base::Matrix force = product(*stiffness, u);
  int interiorNodes = 0;
  const double scale = largest(force);
  for (int node = 0; node < static_cast<int>(patch.mesh.nodes.size()); ++node) {
    if (!patch.interior[node]) continue;
    ++interiorNodes;
    for (int i = 0; i < given.dimension(); ++i)
      EXPECT_LT(std::abs(force(given.dimension() * node + i, 0)), 1e-10 * scale);
  }
  EXPECT_GT(interiorNodes, 0);

  const ElasticityMatrix c = reduced(material.elasticity(), given.kinematics);
  double strain[6] = {gradient[0][0], gradient[1][1], 0.0, gradient[0][1] + gradient[1][0], 0.0, 0.0};
  if (given.dimension() == 3) {
    strain[2] = gradient[2][2];
    strain[4] = gradient[1][2] + gradient[2][1];
    strain[5] = gradient[2][0] + gradient[0][2];
  }
  const base::Matrix stress = elementStress(patch.mesh, patch.piece, material, given.kinematics, u);
  for (int e = 0; e < static_cast<int>(patch.piece.elements.size()); ++e) {
    for (int m = 0; m < 6; ++m) {
      double expected = 0.0;
      for (std::size_t n = 0; n < 6; ++n) expected += c[m][n] * strain[n];
      EXPECT_NEAR(stress(6 * e + m, 0), expected, 1e-10 * largest(stress));
    }
  }
}

TEST_P(EveryElement, passesThePatchTest) {
  passPatchTest(GetParam(), Isotropic(70.0, 0.3));
}

TEST_P(EveryElement, passesThePatchTestWithSkewOrthotropy) {
  passPatchTest(GetParam(), skewOrthotropic(GetParam().dimension()));
}

TEST_P(EveryElement, hasNoForceInRigidMotion) {
  const Case given = GetParam();
  const Patch patch = Patch(given, 2).distort(0.05);
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, skewOrthotropic(given.dimension()),
                                           given.formulation, given.kinematics);
  const double turn3[3][3] = {{0.0, -0.3, 0.2}, {0.3, 0.0, -0.5}, {-0.2, 0.5, 0.0}};
  const base::Matrix force = product(*stiffness, linearField(patch.mesh, turn3, 1.0));
  const base::Matrix strained =
      product(*stiffness, linearField(patch.mesh, {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}));
  EXPECT_LT(largest(force), 1e-12 * largest(strained));
}

TEST_P(EveryElement, bodyForceIsForceTimesVolume) {
  const Case given = GetParam();
  const int dimension = given.dimension();
  const Patch patch = Patch(given, 2).distort(0.05);
  const base::Vector3 density{3.0, -2.0, dimension == 3 ? 5.0 : 0.0};
  const Isotropic material(1.0, 0.0);
  std::vector<double> forces(dimension * patch.piece.nodes.size());
  BodyForce({patch.mesh, patch.piece, material, given.formulation, given.kinematics, 0.5})
      .addTo(forces.data(), {density, {}});
  // Volume from the divergence theorem: with unit pressure stress the forces do the work of the volume change.
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, Isotropic(1.0, 0.0), Formulation::fullIntegration,
                                           given.kinematics, 0.5);
  const base::Matrix u = linearField(patch.mesh, {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
  const base::Matrix f = product(*stiffness, u);
  double volume = 0.0;
  for (int i = 0; i < u.numRows(); ++i) volume += u(i, 0) * f(i, 0);
  for (int i = 0; i < dimension; ++i) {
    double sum = 0.0;
    for (std::size_t k = static_cast<std::size_t>(i); k < forces.size(); k += static_cast<std::size_t>(dimension))
      sum += forces[k];
    EXPECT_NEAR(sum, density[i] * volume, 1e-12);
  }
}

/// A material that expands, but not alike in all directions where it is asked to.
class Warm : public Material {
 public:
  explicit Warm(const Strain& expansion) : expansion_(expansion) {}
  ElasticityMatrix elasticity() const override { return elastic_.elasticity(); }
  std::optional<Strain> thermalExpansion() const override { return expansion_; }

 private:
  Isotropic elastic_{100.0, 0.3};
  Strain expansion_;
};

// What expands freely, u_i = alpha_i T x_i, is pushed there by its thermal forces and has no stress.
TEST_P(EveryElement, expandsFreelyWithoutStress) {
  const Case given = GetParam();
  if (given.kinematics == Kinematics::planeStrain) return;  // does not expand along z
  const Patch patch = Patch(given, 2).distort(0.05);
  const Warm material({2e-3, -1e-3, 3e-3, 0.0, 0.0, 0.0});
  base::Matrix temperature(static_cast<int>(patch.piece.nodes.size()), 1);
  temperature.putScalar(7.0);
  const ElasticPart part{patch.mesh, patch.piece, material, given.formulation, given.kinematics, 0.5, &temperature};
  const base::Matrix u =
      linearField(patch.mesh, {{7.0 * 2e-3, 0.0, 0.0}, {0.0, -7.0 * 1e-3, 0.0}, {0.0, 0.0, 7.0 * 3e-3}});
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, material, given.formulation, given.kinematics, 0.5);
  base::Matrix forces = thermalForces(part);
  const double size = largest(forces);
  forces -= product(*stiffness, u);
  EXPECT_GT(size, 0.01);
  EXPECT_LT(largest(forces), 1e-12 * size);
  EXPECT_LT(largest(elementStress(patch.mesh, patch.piece, material, given.kinematics, u, &temperature)), 1e-12);
  visitElements(part, PointSet::sampling, u, [&](const ElementPoints& at) {
    const double* stress = at.stress();
    for (int i = 0; i < 6 * at.points * u.numCols(); ++i) EXPECT_NEAR(stress[i], 0.0, 1e-12);
  });
}

// A field that is linear in the place, integrated exactly on straight elements: with rigid motions it does the work of
// its resultants.
TEST_P(EveryElement, bodyForcesMayBeLinear) {
  const Case given = GetParam();
  const Patch patch(given, 2);
  const auto dimension = static_cast<std::size_t>(given.dimension());
  const Isotropic material(1.0, 0.0);
  std::vector<double> forces(dimension * patch.piece.nodes.size());
  // A box of 1 x 0.8 (x 1.2), 0.5 thick in the plane.
  BodyForce({patch.mesh, patch.piece, material, given.formulation, given.kinematics, 0.5})
      .addTo(forces.data(), {{1.0, 0.0, 0.0}, {base::Vector3{3.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}});
  double x = 0.0, y = 0.0, moment = 0.0, low = patch.mesh.nodes[0][0];
  for (const base::Vector3& node : patch.mesh.nodes) low = std::min(low, node[0]);
  for (std::size_t k = 0; k < patch.piece.nodes.size(); ++k) {
    x += forces[dimension * k];
    y += forces[dimension * k + 1];
    moment += forces[dimension * k + 1] * patch.mesh.nodes[patch.piece.nodes[k]][0];
  }
  const double area = dimension == 3 ? 0.8 * 1.2 : 0.8 * 0.5, end = low + 1.0;
  EXPECT_NEAR(x, area * (1.0 + 1.5 * (end * end - low * low)), 1e-12);
  EXPECT_NEAR(y, area * (end * end - low * low), 1e-12);
  EXPECT_NEAR(moment, area * 2.0 / 3.0 * (end * end * end - low * low * low), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Elements, EveryElement, testing::ValuesIn(everyCase()),
                         [](const auto& given) { return given.param.name(); });

}  // namespace
}  // namespace harmos::elasticity
