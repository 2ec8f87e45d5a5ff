#include <harmos/elasticity/ElementPoints.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include <harmos/base/Error.hpp>
#include <harmos/elasticity/detail/ElementFault.hpp>
#include <harmos/elasticity/detail/ElementStrain.hpp>
#include <harmos/elasticity/detail/PartElements.hpp>
#include <harmos/elasticity/detail/ThermalStress.hpp>
#include <harmos/mesh/Depth.hpp>

namespace harmos::elasticity {
namespace {

/// The element of twice the order with the same corners, whose points integrate squares.
mesh::ElementType raised(mesh::ElementType type) {
  switch (type) {
    case mesh::ElementType::tri3:
      return mesh::ElementType::tri6;
    case mesh::ElementType::quad4:
      return mesh::ElementType::quad9;
    case mesh::ElementType::tet4:
      return mesh::ElementType::tet10;
    case mesh::ElementType::wedge6:
      return mesh::ElementType::wedge15;
    case mesh::ElementType::hex8:
      return mesh::ElementType::hex27;
    default:
      return type;
  }
}

/// Whose points of full integration are where stress is sampled.
mesh::ElementType sampled(mesh::ElementType type) {
  const mesh::ElementType linear = mesh::linearType(type);
  const bool isBrick = linear == mesh::ElementType::quad4 || linear == mesh::ElementType::hex8;
  return isBrick ? linear : type;
}

mesh::ElementType ruleOf(PointSet points, mesh::ElementType type) {
  if (points == PointSet::stiffness) return type;
  if (points == PointSet::sampling) return sampled(type);
  const bool isBrick = type == mesh::ElementType::quad4 || type == mesh::ElementType::hex8;
  return points == PointSet::squares && isBrick ? type : raised(type);
}

/// Temperatures at a point, of every column.
void temperaturesAt(const base::Matrix& temperature, const ElementPoint& point, const double* weights,
                    std::vector<double>& result) {
  for (int j = 0; j < temperature.numCols(); ++j) {
    result[j] = 0.0;
    for (int a = 0; a < point.nodes; ++a) result[j] += weights[a] * temperature(point.node[a], j);
  }
}

}  // namespace

void forEachPoint(const ElasticPart& part, PointSet points, const base::Matrix& displacements,
                  const std::function<void(const ElementPoint&)>& visit) {
  const int components = componentsOf(part.kinematics), columns = displacements.numCols();
  const int dofs = components * static_cast<int>(part.piece.nodes.size());
  if (displacements.numRows() != dofs) {
    throw base::Error("Part \"" + part.piece.name + "\" has " + std::to_string(dofs) +
                      " degrees of freedom; displacements of " + std::to_string(displacements.numRows()) +
                      " were given.");
  }
  const ElasticityMatrix c = reduced(part.material.elasticity(), part.kinematics);
  const mesh::Depth depth = isAxisymmetric(part.kinematics) ? mesh::Depth::revolved() : mesh::Depth(part.thickness);
  std::vector<double> stress(6 * static_cast<std::size_t>(columns));
  const Strain hot = thermalStress(part.material, part.kinematics);
  const int temperatures = part.temperature ? part.temperature->numCols() : 0;
  std::vector<double> temperature(temperatures);
  ElementFaults faults(part.mesh, part.piece);
  for (const ElementGroup& group : groupsOf(part.mesh, part.piece, part.kinematics)) {
    const mesh::ElementType type = group.block->type;
    const mesh::ReferenceElement rule = mesh::referenceElement(ruleOf(points, type));
    const bool isLinear = mesh::linearType(type) == type;
    // Around a hoop even these strain by u_x / x.
    const bool isConstant =
        (type == mesh::ElementType::tri3 || type == mesh::ElementType::tet4) && !isAxisymmetric(part.kinematics);
    ElementStrain strain(type, part.formulation, part.kinematics, c, rule.place);
    const int nodes = group.nodesPerElement();
    std::vector<base::Vector3> places(nodes);
    base::Matrix values(components * nodes, columns);
    for (int number = 0; number < group.elements(); ++number) {
      ElementPoint point;
      point.element = group.firstElement + number;
      point.nodes = nodes;
      point.node = group.nodesOf(number);
      point.strain = &strain;
      point.temperature = temperature.data();
      point.stress = stress.data();
      for (int a = 0; a < nodes; ++a) {
        places[a] = part.mesh.nodes[part.piece.nodes[point.node[a]]];
        for (int j = 0; j < columns; ++j) {
          std::copy_n(displacements[j] + components * point.node[a], components, values[j] + components * a);
        }
      }
      if (!strain.set(places, values)) {
        faults.add(group, number);
        continue;
      }
      const std::vector<double> mean = strain.meanValues();
      for (int p = 0; p < rule.points; ++p) {
        point.number = p;
        point.value = strain.values(p);
        point.position = {};
        for (int a = 0; a < nodes; ++a) point.position = point.position + point.value[a] * places[a];
        const double across = dimensionOf(part.kinematics) == 2 ? depth.at(point.position) : 1.0;
        point.volume = across * rule.weight[p] * strain.determinant(p);
        if (isConstant && p > 0) {
          visit(point);
          continue;
        }
        if (temperatures > 0) {
          temperaturesAt(*part.temperature, point, isLinear ? mean.data() : point.value, temperature);
        }
        for (int j = 0; j < columns; ++j) {
          const double degrees = j < temperatures ? temperature[j] : 0.0;
          const std::array<double, 6> eps = strain.strain(p, j);
          for (std::size_t m = 0; m < 6; ++m) {
            stress[6 * static_cast<std::size_t>(j) + m] =
                std::inner_product(eps.begin(), eps.end(), c[m].begin(), 0.0) - degrees * hot[m];
          }
        }
        visit(point);
      }
    }
  }
  faults.throwIfAny();
}

}  // namespace harmos::elasticity
