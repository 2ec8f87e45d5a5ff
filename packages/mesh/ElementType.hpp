#pragma once

#include <optional>
#include <string>
#include <vector>

namespace harmos::mesh {

/// The supported elements, all linear; nodes and sides are numbered as in Exodus II and Shards, which agree for them.
enum class ElementType { tri3, quad4, tet4, pyramid5, wedge6, hex8 };

/// From 3 of tri3 to 8 of hex8.
int nodesPerElement(ElementType type);
/// 2 for tri3 and quad4, 3 for the others.
int dimensionOf(ElementType type);
/// Exodus name in upper case, for example "HEX8".
const char* exodusName(ElementType type);
/// The element that an Exodus block of this type name (any case), dimension and nodes per element holds; none if it is
/// not supported. Shells count as plane elements in 2-D and are not supported in 3-D.
std::optional<ElementType> elementTypeFromExodus(const std::string& name, int dimension, int nodes);
/// Faces of an element, edges in 2-D.
int sidesPerElement(ElementType type);
/// Local node numbers of side `side` (both 0-based), in the order of Shards: counter-clockwise seen from outside. The
/// side is not checked.
const std::vector<int>& sideNodes(ElementType type, int side);

}  // namespace harmos::mesh
