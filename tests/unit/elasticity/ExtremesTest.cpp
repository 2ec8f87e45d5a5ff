#include <gtest/gtest.h>

#include <harmos/elasticity/Stiffness.hpp>
#include <harmos/elasticity/Stress.hpp>
#include <harmos/elasticity/detail/Isotropic.hpp>
#include <harmos/substructure/SubstructureSolver.hpp>

#include "Patches.hpp"

namespace harmos::elasticity {
namespace {

/// Stretches a box that springs hold at x = 0: solves (K + S) u = (K + S) u0 for a known u0 of unit stress along x and
/// returns sigma_xx of every element of u.
base::Matrix stressOfStretch(const Case& given, double youngsModulus, const base::Vector3& extent) {
  const Patch patch(given, mesh::isQuadratic(given.type) ? 1 : 2, extent);
  const Isotropic material(youngsModulus, 0.0);
  const int dimension = given.dimension();
  const auto stiffness = assembleStiffness(patch.mesh, patch.piece, material, given.formulation, given.kinematics);
  const base::Matrix exact =
      linearField(patch.mesh, {{1.0 / youngsModulus, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, 1.0 / youngsModulus);
  base::Matrix load = product(*stiffness, exact);
  substructure::BoundaryTerm springs;
  springs.dimension = dimension;
  springs.diagonal.assign(exact.numRows(), 0.0);
  const std::vector<double> diagonal = substructure::nodalStiffnessDiagonal(*stiffness, dimension);
  for (int dof = 0; dof < exact.numRows(); ++dof) {
    const auto node = static_cast<std::size_t>(dof / dimension);
    if (patch.mesh.nodes[node][0] > 0.0) continue;
    springs.diagonal[dof] = diagonal[node];
    load(dof, 0) += diagonal[node] * exact(dof, 0);
  }
  base::Matrix solution;
  substructure::SubstructureSolver(stiffness, springs, {}, "sliver").solve(load, solution);
  return elementStress(patch.mesh, patch.piece, material, given.kinematics, solution);
}

TEST(Extremes, stiffnessScalesFromRubberToRigid) {
  for (const Case& given : everyCase()) {
    for (const double youngsModulus : {1e-6, 1.0, 1e12}) {
      const base::Matrix stress = stressOfStretch(given, youngsModulus, {1.0, 0.8, 1.2});
      for (int row = 0; row < stress.numRows(); row += 6) EXPECT_NEAR(stress(row, 0), 1.0, 1e-9) << given.name();
    }
  }
}

TEST(Extremes, sliversAreSolved) {
  // Condition 1e8 to 1e10: rounding grows to about 1e-6. It goes with the second power of the aspect where elements
  // lock in bending, with the fourth where they bend as they should.
  for (const Case& given : everyCase()) {
    const bool bends = mesh::isQuadratic(given.type) || given.formulation == Formulation::incompatibleModes;
    const double aspect = bends ? 1e2 : 1e4;
    for (const base::Vector3& extent :
         {base::Vector3{aspect, 1.0, 1.0}, base::Vector3{1.0, aspect, 1.0}, base::Vector3{1.0, 1.0, 1.0 / aspect}}) {
      const base::Matrix stress = stressOfStretch(given, 1.0, extent);
      for (int row = 0; row < stress.numRows(); row += 6) EXPECT_NEAR(stress(row, 0), 1.0, 1e-4) << given.name();
    }
  }
}

}  // namespace
}  // namespace harmos::elasticity
