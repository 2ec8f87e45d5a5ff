#pragma once

#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/ElementType.hpp>

namespace harmos::mesh {

/// Shape functions N_a of an element type at points of its reference element, with coordinates xi as in Intrepid2.
struct ShapeFunctions {
  int dimension = 0;             ///< of the reference element
  int nodes = 0;                 ///< of the element
  int points = 0;                ///< places at which the functions are known
  std::vector<double> value;     ///< N_a: points x nodes
  std::vector<double> gradient;  ///< dN_a/dxi_j: points x nodes x dimension
};

/// The same at quadrature points.
struct ReferenceElement : ShapeFunctions {
  std::vector<double> weight;        ///< per quadrature point
  std::vector<base::Vector3> place;  ///< xi of the quadrature points
};

/// Full integration. Linear elements: 2 points per direction for hex8 and quad4, exact for straight-edged elements of
/// the other types. Quadratic ones: 3 points per direction for hexahedra and quadrilaterals, 6 for tri6, 14 for tet10,
/// 18 for wedge15, all weights positive: forces of a constant stress are exact on curved elements too.
///
/// Serendipity elements (quad8, wedge15, hex20) are those of Intrepid2's full basis (quad9, wedge18, hex27), whose
/// values at the middles of faces and of the volume follow from the other nodes.
ReferenceElement referenceElement(ElementType type);

/// Shape functions at points xi of the reference element.
ShapeFunctions shapeFunctions(ElementType type, const std::vector<base::Vector3>& places);

/// xi of the nodes.
std::vector<base::Vector3> nodePlaces(ElementType type);

}  // namespace harmos::mesh
