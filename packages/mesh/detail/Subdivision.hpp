#pragma once

#include <utility>
#include <vector>

#include <harmos/mesh/ReferenceElement.hpp>

namespace harmos::mesh {

/// How an element is divided into elements of a type, in coordinates xi of its reference element.
struct Subdivision {
  ElementType type;                        ///< of the children
  std::vector<base::Vector3> places;       ///< xi of all their nodes, each once
  std::vector<std::vector<int>> children;  ///< positions in `places` of the nodes of each
  ShapeFunctions geometry;                 ///< of the parent, at `places`
  ShapeFunctions corners;                  ///< the same of the linear element with the parent's corners
  /// Per side of the parent, the parts of it: child and its side.
  std::vector<std::vector<std::pair<int, int>>> sides;

  /// `cornersOfChildren`: xi of the corners of each child.
  Subdivision(ElementType parent, ElementType childType,
              const std::vector<std::vector<base::Vector3>>& cornersOfChildren);
};

/// Corners of the children that refined() makes of an element: 4 in the plane, 8 in space; of pyramids there are none.
/// Tetrahedra have three choices, along the diagonals between the middles of edges 0 and 5, 1 and 3, 2 and 4.
std::vector<std::vector<std::vector<base::Vector3>>> splits(ElementType type);

}  // namespace harmos::mesh
