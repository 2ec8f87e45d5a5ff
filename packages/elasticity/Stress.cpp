#include <harmos/elasticity/Stress.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <harmos/elasticity/detail/ElementLoop.hpp>
#include <harmos/elasticity/detail/StrainOperator.hpp>
#include <harmos/elasticity/detail/ThermalStress.hpp>

namespace harmos::elasticity {

base::Matrix elementStress(const mesh::Mesh& mesh, const mesh::Piece& piece, const Material& material,
                           Kinematics kinematics, const base::Matrix& displacements, const base::Matrix* temperature) {
  const int components = componentsOf(kinematics), dofs = components * static_cast<int>(piece.nodes.size());
  if (displacements.numRows() != dofs) {
    throw base::Error("Part \"" + piece.name + "\" has " + std::to_string(dofs) +
                      " degrees of freedom; displacements of " + std::to_string(displacements.numRows()) +
                      " were given.");
  }
  const ElasticityMatrix c = reduced(material.elasticity(), kinematics);
  const Strain hot = thermalStress(material, kinematics);
  const StrainOperator operators(kinematics);
  base::Matrix stress(6 * static_cast<int>(piece.elements.size()), displacements.numCols());
  forEachElement(mesh, piece, groupsOf(mesh, piece, kinematics), Formulation::fullIntegration, kinematics, false,
                 [&](const ElementGroup& group, int number, const ElementBasis&, const ElementIntegrals& integrals) {
                   const int perElement = group.nodesPerElement();
                   const int* local = group.nodesOf(number);
                   for (int column = 0; column < displacements.numCols(); ++column) {
                     double h[3][3] = {};  // mean of gradient k times component i
                     for (int a = 0; a < perElement; ++a) {
                       for (int i = 0; i < components; ++i) {
                         const double u = displacements(components * local[a] + i, column) / integrals.volume;
                         for (int k = 0; k < operators.gradients; ++k)
                           h[i][k] += u * integrals.gradient.data()[operators.gradients * a + k];
                       }
                     }
                     const std::array<double, 6> strain = operators.strain(h);
                     double degrees = 0.0;
                     if (temperature != nullptr && column < temperature->numCols()) {
                       for (int a = 0; a < perElement; ++a) {
                         degrees += integrals.value[a] / integrals.volume * (*temperature)(local[a], column);
                       }
                     }
                     double* result = stress[column] + 6 * (group.firstElement + number);
                     for (std::size_t m = 0; m < 6; ++m) {
                       result[m] = -degrees * hot[m];
                       for (std::size_t n = 0; n < 6; ++n) result[m] += c[m][n] * strain[n];
                     }
                   }
                 });
  return stress;
}

double vonMises(const double* s) {
  const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

std::array<double, 3> principalStresses(const double* s) {
  // Of the deviator: lambda = 2 sqrt(J2/3) cos(angle), cos(3 angle) = (3 sqrt(3) / 2) J3 / J2^(3/2).
  const double mean = (s[0] + s[1] + s[2]) / 3.0;
  const double x = s[0] - mean, y = s[1] - mean, z = s[2] - mean, xy = s[3], yz = s[4], zx = s[5];
  const double radius = vonMises(s) / 1.5;  // 2 sqrt(J2/3)
  if (radius == 0.0) return {mean, mean, mean};
  const double j3 = x * (y * z - yz * yz) - xy * (xy * z - yz * zx) + zx * (xy * yz - y * zx);
  const double angle = std::acos(std::clamp(4.0 * j3 / (radius * radius * radius), -1.0, 1.0)) / 3.0;
  const double third = 2.0943951023931953;  // of a turn, 2 pi / 3
  return {mean + radius * std::cos(angle), mean + radius * std::cos(angle - third),
          mean + radius * std::cos(angle + third)};
}

}  // namespace harmos::elasticity
