#pragma once

#include <vector>

#include <harmos/mesh/ElementType.hpp>

namespace harmos::elasticity {

/// Basis functions of an element type at the quadrature points of its reference element.
struct ReferenceElement {
  int dimension = 0;
  int nodes = 0;
  int points = 0;
  std::vector<double> weight;    ///< per point
  std::vector<double> value;     ///< N_a: points x nodes
  std::vector<double> gradient;  ///< dN_a/dxi_j: points x nodes x dimension
};

/// Full integration: 2 points per direction for hex8 and quad4, exact for straight-edged elements of the other types.
ReferenceElement referenceElement(mesh::ElementType type);

}  // namespace harmos::elasticity
