#include <harmos/scene/detail/VolumetricLocking.hpp>

#include <algorithm>

#include <harmos/mesh/Elements.hpp>

namespace harmos::scene {
namespace {

// Bulk modulus over shear modulus of an isotropic material of Poisson's ratio 0.49, but for round-off.
constexpr double nearlyIncompressible = 2.0 * 1.49 / (3.0 * 0.02) - 1e-6;

/// Bulk modulus over the mean shear modulus.
double bulkOverShear(const elasticity::ElasticityMatrix& c) {
  double bulk = 0.0, shear = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) bulk += c[i][j] / 9.0;
    shear += c[i + 3][i + 3] / 3.0;
  }
  return bulk / shear;
}

}  // namespace

std::string lockingRemedy(const Problem& problem, int body) {
  const auto b = static_cast<std::size_t>(body);
  const elasticity::Kinematics kinematics = problem.model.kinematics;
  // In plane stress the thickness gives way.
  if (kinematics == elasticity::Kinematics::planeStress ||
      problem.bodies.parts[b].formulation != elasticity::Formulation::fullIntegration ||
      bulkOverShear(problem.bodies.materials[b]->elasticity()) < nearlyIncompressible) {
    return "";
  }
  const mesh::Elements elements(problem.mesh);
  const std::vector<int>& own = problem.bodies.pieces[b].elements;
  const bool canHaveIt = std::all_of(own.begin(), own.end(), [&](int element) {
    const mesh::ElementType type = elements.type(element);
    return type != mesh::ElementType::tri3 && type != mesh::ElementType::tet4 && !mesh::isQuadratic(type);
  });
  std::string text = "is nearly incompressible, its elements lock: ";
  if (!canHaveIt) text += std::string("mesh it with ") + (problem.mesh.dimension == 2 ? "QUAD4" : "HEX8") + " and ";
  return text + "choose Formulation = B-Bar";
}

}  // namespace harmos::scene
