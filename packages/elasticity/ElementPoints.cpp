#include <harmos/elasticity/ElementPoints.hpp>

#include <algorithm>
#include <string>
#include <utility>

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

/// Where, and with which weights.
struct Rule {
  std::vector<base::Vector3> place;
  std::vector<double> weight;
};

Rule ruleOf(PointSet points, mesh::ElementType type, bool isConstant) {
  if (points == PointSet::squares && isConstant) {
    // Squares of what is linear between the nodes: they and the centre.
    Rule rule{mesh::nodePlaces(type), {}};
    const mesh::ReferenceElement centre = mesh::referenceElement(type);
    const double nodes = centre.nodes, inNode = 1.0 / (nodes * (nodes + 1.0));
    rule.weight.assign(rule.place.size(), centre.weight[0] * inNode);
    rule.place.push_back(centre.place[0]);
    rule.weight.push_back(centre.weight[0] * (1.0 - nodes * inNode));
    return rule;
  }
  const bool isBrick = type == mesh::ElementType::quad4 || type == mesh::ElementType::hex8;
  mesh::ElementType of = raised(type);
  if (points == PointSet::stiffness || (points == PointSet::squares && isBrick)) of = type;
  if (points == PointSet::sampling) of = sampled(type);
  mesh::ReferenceElement reference = mesh::referenceElement(of);
  return {std::move(reference.place), std::move(reference.weight)};
}

/// Temperature at points of an element: points x columns.
void findTemperature(const base::Matrix& temperature, const ElementPoints& at, const std::vector<double>& mean,
                     std::vector<double>& result) {
  const int columns = temperature.numCols();
  result.assign(static_cast<std::size_t>(at.points) * static_cast<std::size_t>(columns), 0.0);
  for (int p = 0; p < at.points; ++p) {
    const double* weights = mean.empty() ? at.value + static_cast<std::ptrdiff_t>(p) * at.nodes : mean.data();
    for (int j = 0; j < columns; ++j) {
      for (int a = 0; a < at.nodes; ++a) result[p * columns + j] += weights[a] * temperature(at.node[a], j);
    }
  }
}

/// Adds C : strain at a point, both six components x columns.
void addStress(const ElasticityMatrix& c, const double* strain, int columns, double* stress) {
  for (std::size_t m = 0; m < 6; ++m) {
    double* to = stress + m * static_cast<std::size_t>(columns);
    for (std::size_t n = 0; n < 6; ++n) {
      if (c[m][n] == 0.0) continue;
      const double* from = strain + n * static_cast<std::size_t>(columns);
      for (int j = 0; j < columns; ++j) to[j] += c[m][n] * from[j];
    }
  }
}

/// Displacements of the nodes of an element: columns x (components x nodes).
void gather(const base::Matrix& displacements, int components, const ElementPoints& at, base::Matrix& values) {
  for (int a = 0; a < at.nodes; ++a) {
    for (int i = 0; i < components; ++i) {
      double* to = values[components * a + i];
      for (int j = 0; j < displacements.numCols(); ++j) to[j] = displacements(components * at.node[a] + i, j);
    }
  }
}

}  // namespace

void visitElements(const ElasticPart& part, PointSet points, const base::Matrix& displacements,
                   const std::function<void(const ElementPoints&)>& visit) {
  const int components = componentsOf(part.kinematics), columns = displacements.numCols();
  const int dofs = components * static_cast<int>(part.piece.nodes.size());
  if (columns > 0 && displacements.numRows() != dofs) {
    throw base::Error("Part \"" + part.piece.name + "\" has " + std::to_string(dofs) +
                      " degrees of freedom; displacements of " + std::to_string(displacements.numRows()) +
                      " were given.");
  }
  const ElasticityMatrix c = reduced(part.material.elasticity(), part.kinematics);
  const mesh::Depth depth = isAxisymmetric(part.kinematics) ? mesh::Depth::revolved() : mesh::Depth(part.thickness);
  const Strain hot = thermalStress(part.material, part.kinematics);
  const int temperatures = part.temperature ? part.temperature->numCols() : 0;
  ElementFaults faults(part.mesh, part.piece);
  for (const ElementGroup& group : groupsOf(part.mesh, part.piece, part.kinematics)) {
    const mesh::ElementType type = group.block->type;
    // Around a hoop even these strain by u_x / x.
    const bool isConstant =
        (type == mesh::ElementType::tri3 || type == mesh::ElementType::tet4) && !isAxisymmetric(part.kinematics);
    const Rule rule = ruleOf(points, type, isConstant);
    const bool isLinear = mesh::linearType(type) == type;
    ElementStrain strain(type, part.formulation, part.kinematics, c, rule.place);
    ElementPoints at;
    at.nodes = group.nodesPerElement();
    at.points = static_cast<int>(rule.place.size());
    at.value = strain.values(0);
    at.isConstant = isConstant;
    at.strain = &strain;
    const auto atPoint = 6 * static_cast<std::size_t>(columns);
    std::vector<base::Vector3> places(at.nodes), position(at.points);
    std::vector<double> volume(at.points), temperature, strains(atPoint), stress(atPoint * rule.place.size());
    base::Matrix values(columns, components * at.nodes);
    at.position = position.data();
    at.volume = volume.data();
    at.stress = [&] {
      gather(displacements, components, at, values);
      strain.displace(values);
      std::fill(stress.begin(), stress.end(), 0.0);
      for (int p = 0; p < at.points; ++p) {
        double* here = stress.data() + p * atPoint;
        if (isConstant && p > 0) {
          std::copy_n(stress.data(), atPoint, here);
          continue;
        }
        strain.findStrain(p, strains.data());
        addStress(c, strains.data(), columns, here);
        for (std::size_t m = 0; m < 6 && temperatures > 0; ++m) {
          for (int j = 0; j < std::min(columns, temperatures); ++j) {
            here[m * static_cast<std::size_t>(columns) + j] -= at.temperature[p * temperatures + j] * hot[m];
          }
        }
      }
      return stress.data();
    };
    for (int number = 0; number < group.elements(); ++number) {
      at.element = group.firstElement + number;
      at.node = group.nodesOf(number);
      for (int a = 0; a < at.nodes; ++a) places[a] = part.mesh.nodes[part.piece.nodes[at.node[a]]];
      if (!strain.set(places)) {
        faults.add(group, number);
        continue;
      }
      for (int p = 0; p < at.points; ++p) {
        position[p] = {};
        for (int a = 0; a < at.nodes; ++a) position[p] = position[p] + strain.values(p)[a] * places[a];
        const double across = dimensionOf(part.kinematics) == 2 ? depth.at(position[p]) : 1.0;
        volume[p] = across * rule.weight[p] * strain.determinant(p);
      }
      if (temperatures > 0) {
        findTemperature(*part.temperature, at, isLinear ? strain.meanValues() : std::vector<double>(), temperature);
        at.temperature = temperature.data();
      }
      visit(at);
    }
  }
  faults.throwIfAny();
}

void visitElements(const ElasticPart& part, PointSet points, const std::function<void(const ElementPoints&)>& visit) {
  visitElements(part, points, base::Matrix(), visit);
}

}  // namespace harmos::elasticity
