#include <gtest/gtest.h>

#include <harmos/elasticity/BodyForce.hpp>
#include <harmos/elasticity/ElementPoints.hpp>
#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/elasticity/Stress.hpp>
#include <harmos/elasticity/ThermalLoad.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr Kinematics torsion = Kinematics::axisymmetricWithTorsion;
constexpr double length = 0.8, radius = 1.0;

/// Displacements of the nodes of a half plane.
template <class Field>
base::Matrix displaced(const mesh::Mesh& mesh, const Field& field) {
  base::Matrix u(3 * static_cast<int>(mesh.nodes.size()), 1);
  for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
    const base::Vector3 at = field(mesh.nodes[node]);
    for (int c = 0; c < 3; ++c) u(3 * node + c, 0) = at[c];
  }
  return u;
}

double work(const base::Matrix& force, const base::Matrix& u) {
  double sum = 0.0;
  for (int i = 0; i < u.numRows(); ++i) sum += force(i, 0) * u(i, 0);
  return sum;
}

class EveryHalfPlane : public testing::TestWithParam<Case> {};

// Along the axis and about it nothing resists; whatever the material, a motion of the plane that is rigid is none here.
TEST_P(EveryHalfPlane, movesAndTurnsFreely) {
  const Patch patch = Patch(GetParam(), 2);
  const Orthotropic material = skewOrthotropic(3);
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, material, GetParam().formulation, torsion);
  const base::Matrix free = displaced(patch.mesh, [](const base::Vector3& x) {
    return base::Vector3{0.0, 0.7, -0.3 * x[0]};
  });
  for (const base::Vector3& resisted : {base::Vector3{1.0, 0.0, 0.0}, base::Vector3{0.0, 0.0, 1.0}}) {
    const base::Matrix u =
        displaced(patch.mesh, [&](const base::Vector3& x) { return x[0] == 0.0 ? base::Vector3{} : resisted; });
    EXPECT_LT(largest(product(*stiffness, free)), 1e-12 * largest(product(*stiffness, u)));
  }
}

// A shaft with nodes on the axis, twisted by theta per length: energy G theta^2 (pi R^4 / 2) L / 2.
TEST_P(EveryHalfPlane, shaftStoresTheEnergyOfItsTwist) {
  const Patch patch = Patch(GetParam(), 2);
  const Isotropic material(70.0, 0.3);
  constexpr double theta = 0.01, shear = 70.0 / 2.6;
  const base::Matrix u = displaced(patch.mesh, [](const base::Vector3& x) {
    return base::Vector3{0.0, 0.0, -theta * x[0] * x[1]};
  });
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, material, GetParam().formulation, torsion);
  const double exact = shear * theta * theta * 0.5 * pi * length;
  // Linear triangles do not have the field.
  const double tolerance = GetParam().type == mesh::ElementType::tri3 ? 0.3 : 1e-12;
  EXPECT_NEAR(work(product(*stiffness, u), u), exact, tolerance * exact);
  if (GetParam().type == mesh::ElementType::tri3) return;
  const ElasticPart part{patch.mesh, patch.piece, material, GetParam().formulation, torsion};
  visitElements(part, PointSet::stiffness, u, [&](const ElementPoints& at) {
    const double* stress = at.stress();
    for (int p = 0; p < at.points; ++p, stress += 6) {
      for (const std::size_t m : {0U, 1U, 2U, 3U, 5U}) EXPECT_NEAR(stress[m], 0.0, 1e-12);
      EXPECT_NEAR(stress[4], -shear * theta * at.position[p][0], 1e-12);
    }
  });
  const base::Matrix mean = elementStress(patch.mesh, patch.piece, material, torsion, u);
  for (int e = 0; e < static_cast<int>(patch.piece.elements.size()); ++e) EXPECT_LT(mean(6 * e + 4, 0), 0.0);
}

// What torsion adds leaves the rest as it was.
TEST_P(EveryHalfPlane, isThatWithoutTorsionWhereNothingTwists) {
  const Patch patch = Patch(GetParam(), 2).distort(0.02);
  mesh::Mesh mesh = patch.mesh;
  for (base::Vector3& x : mesh.nodes) x[0] += 0.5;
  const Isotropic material(70.0, 0.3);
  const auto with = assembleStiffness(mesh, patch.piece, material, GetParam().formulation, torsion);
  const auto without = assembleStiffness(mesh, patch.piece, material, GetParam().formulation, Kinematics::axisymmetric);
  const auto field = [](const base::Vector3& x) { return base::Vector3{x[0] * x[1], x[0] - x[1] * x[1], 0.0}; };
  base::Matrix plane(2 * static_cast<int>(mesh.nodes.size()), 1);
  for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
    for (int c = 0; c < 2; ++c) plane(2 * node + c, 0) = field(mesh.nodes[node])[c];
  }
  const base::Matrix f = product(*with, displaced(mesh, field)), expected = product(*without, plane);
  for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
    for (int c = 0; c < 2; ++c) EXPECT_NEAR(f(3 * node + c, 0), expected(2 * node + c, 0), 1e-12 * largest(expected));
    EXPECT_NEAR(f(3 * node + 2, 0), 0.0, 1e-12 * largest(expected));
  }
}

// Inertia that is linear in the radius has the moment rho e of the polar moment of inertia, pi R^4 L / 2.
TEST_P(EveryHalfPlane, bodyForceAroundTheHoopHasItsMoment) {
  const Patch patch = Patch(GetParam(), 2);
  const Isotropic material(1.0, 0.0);
  std::vector<double> forces(3 * patch.piece.nodes.size());
  base::Tensor3 slope{};
  slope[2] = {2.0, 0.0, 0.0};
  BodyForce({patch.mesh, patch.piece, material, GetParam().formulation, torsion}).addTo(forces.data(), {{}, slope});
  double moment = 0.0;
  for (std::size_t node = 0; node < patch.piece.nodes.size(); ++node) {
    const double x = patch.mesh.nodes[patch.piece.nodes[node]][0];
    moment -= x * forces[3 * node + 2];
    if (x == 0.0) {
      EXPECT_EQ(forces[3 * node + 2], 0.0);
    }
  }
  EXPECT_NEAR(moment, -2.0 * 0.5 * pi * length * radius, 1e-12);
}

std::vector<Case> halfPlanes() {
  using Type = mesh::ElementType;
  std::vector<Case> cases;
  for (const Type type : {Type::tri3, Type::quad4, Type::tri6, Type::quad8, Type::quad9}) {
    cases.push_back({type, torsion, Formulation::fullIntegration});
  }
  cases.push_back({Type::quad4, torsion, Formulation::bBar});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Elements, EveryHalfPlane, testing::ValuesIn(halfPlanes()),
                         [](const auto& given) { return given.param.name(); });

}  // namespace
}  // namespace harmos::elasticity
