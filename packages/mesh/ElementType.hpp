#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harmos::mesh {

/// The supported elements, linear ones first; nodes and sides are numbered as in Exodus II and Shards, which agree for
/// them: corners, then the middles of edges (of hexahedra and wedges: below, upright, above), then those of the volume
/// and of the faces of hex27.
enum class ElementType { tri3, quad4, tet4, pyramid5, wedge6, hex8, tri6, quad8, quad9, tet10, wedge15, hex20, hex27 };

/// From 3 of tri3 to 27 of hex27.
int nodesPerElement(ElementType type);
/// The corners among them, which come first: from 3 to 8.
int cornersPerElement(ElementType type);
/// Whether shape functions are quadratic: there are nodes besides the corners.
bool isQuadratic(ElementType type);
/// The element with the same corners and no other nodes.
ElementType linearType(ElementType type);
/// 2 for triangles and quadrilaterals, 3 for the others.
int dimensionOf(ElementType type);
/// Exodus name in upper case, for example "HEX8".
const char* exodusName(ElementType type);
/// The element that an Exodus block of this type name (any case), dimension and nodes per element holds; none if it is
/// not supported. Shells count as plane elements in 2-D and are not supported in 3-D.
std::optional<ElementType> elementTypeFromExodus(const std::string& name, int dimension, int nodes);
/// How many sides an Exodus block of this type name (any case) counts before those of Harmos: a shell has two faces,
/// and the edges come behind them, also in 2-D.
int sidesBeforeEdges(const std::string& exodusName);
/// Faces of an element, edges in 2-D.
int sidesPerElement(ElementType type);
/// Local node numbers of side `side` (both 0-based), in the order of Shards: corners counter-clockwise seen from
/// outside, then the middles of the edges from the first corner on, then that of the side. The side is not checked.
const std::vector<int>& sideNodes(ElementType type, int side);
/// Local node numbers of all edges in the order of Shards: both ends and, of quadratic elements, the middle. In the
/// plane edges are sides.
const std::vector<std::vector<int>>& edgesOf(ElementType type);

}  // namespace harmos::mesh
