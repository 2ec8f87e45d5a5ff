#include <harmos/scene/detail/CohesiveZones.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <harmos/base/Names.hpp>
#include <harmos/base/Numerals.hpp>
#include <harmos/scene/detail/PointSpacing.hpp>

namespace harmos::scene {
namespace {

constexpr double largestShare = 0.5;

/// Strengths beside the fracture energies of their modes.
constexpr std::pair<const char*, const char*> modes[] = {{"Normal Strength", "Mode I Fracture Energy"},
                                                         {"Shear Strength", "Mode II Fracture Energy"}};

double smallestStiffness(const Bodies& bodies, const assembly::Interface& interface) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int side = 0; side < interface.sides(); ++side) {
    const elasticity::ElasticityMatrix c =
        bodies.materials[static_cast<std::size_t>(interface.body(side))]->elasticity();
    for (std::size_t i = 0; i < 3; ++i) smallest = std::min(smallest, c[i][i]);
  }
  return smallest;
}

/// The list of the interface, if its law is a cohesive zone; else null.
const input::Parameters* findCohesive(const Scene& scene, const std::string& name) {
  for (const input::Parameters& list : scene.input.lists("Interfaces")) {
    if (list.name() == name && list.list("Law").type() == "Cohesive Zone") return &list.list("Law");
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> coarseCohesiveZones(const Scene& scene, const assembly::Assembly& assembly,
                                             const Bodies& bodies, const Model& model) {
  std::vector<std::string> warnings, named;
  if (elasticity::isAxisymmetric(model.kinematics)) return warnings;
  for (const assembly::Interface& interface : assembly.interfaces) {
    const input::Parameters* law = findCohesive(scene, interface.name);
    if (law == nullptr || interface.pairs() == 0 || std::count(named.begin(), named.end(), interface.name) > 0)
      continue;
    double length = std::numeric_limits<double>::infinity();
    for (const auto& [strength, energy] : modes) {
      const double t = law->number(strength);
      length = std::min(length, smallestStiffness(bodies, interface) * law->number(energy) / (t * t));
    }
    const double distance = largestSpacing(interface, assembly.dimension, model);
    if (!(distance > largestShare * length)) continue;
    named.push_back(interface.name);
    warnings.push_back(
        law->where() + ": points of " + base::quoted(interface.name) + " lie up to " + base::toText(distance) +
        " apart, but its cohesive zone, E G / strength^2, is only " + base::toText(length) +
        " long. Refine the mesh there to less than half of it, or lower the strength: a crack that jumps "
        "from point to point needs many load steps, or does not converge.");
  }
  return warnings;
}

}  // namespace harmos::scene
