#include <harmos/elasticity/ThermalLoad.hpp>

#include <vector>

#include <harmos/elasticity/detail/Axis.hpp>
#include <harmos/elasticity/detail/ElementStrain.hpp>
#include <harmos/elasticity/detail/ThermalStress.hpp>

namespace harmos::elasticity {

base::Matrix thermalForces(const ElasticPart& part) {
  const int components = componentsOf(part.kinematics), columns = part.temperature->numCols();
  base::Matrix forces(components * static_cast<int>(part.piece.nodes.size()), columns);
  const Strain hot = thermalStress(part.material, part.kinematics);
  std::vector<double> unit;
  visitElements(part, PointSet::stiffness, [&](const ElementPoints& at) {
    for (int p = 0; p < at.points; ++p) {
      unit.assign(static_cast<std::size_t>(components) * static_cast<std::size_t>(at.nodes), 0.0);
      at.strain->addForces(p, hot, at.volume[p], unit.data());
      for (int j = 0; j < columns; ++j) {
        const double degrees = at.temperature[p * columns + j];
        for (int a = 0; a < at.nodes; ++a) {
          for (int c = 0; c < components; ++c) {
            forces(components * at.node[a] + c, j) += degrees * unit[components * a + c];
          }
        }
      }
    }
  });
  const std::vector<bool> isOnAxis = nodesOnAxis(part.mesh, part.piece, part.kinematics);
  for (std::size_t node = 0; node < isOnAxis.size(); ++node) {
    for (int c = 0; isOnAxis[node] && c < components; ++c) {
      for (int j = 0; j < columns && !isFreeOnAxis(c); ++j) forces(components * static_cast<int>(node) + c, j) = 0.0;
    }
  }
  return forces;
}

}  // namespace harmos::elasticity
