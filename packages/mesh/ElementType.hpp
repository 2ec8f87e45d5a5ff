#pragma once

#include <string>
#include <vector>

namespace harmos::mesh {

enum class ElementType { tri3, quad4, tet4, pyramid5, wedge6, hex8 };

int nodesPerElement(ElementType type);
int dimensionOf(ElementType type);
/// Exodus name in upper case, for example "HEX8".
const char* exodusName(ElementType type);
int sidesPerElement(ElementType type);
/// Local node numbers of side `side` (0-based), in the order of Shards: counter-clockwise seen from outside.
const std::vector<int>& sideNodes(ElementType type, int side);

}  // namespace harmos::mesh
