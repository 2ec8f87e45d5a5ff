#include <harmos/mesh/ElementType.hpp>

#include <array>
#include <cctype>

#include <Shards_BasicTopologies.hpp>

namespace harmos::mesh {
namespace {

struct Topology {
  ElementType type;
  const char* name;
  std::vector<const char*> exodusNames;  // accepted when reading
  const CellTopologyData* shards;
  std::vector<std::vector<int>> sides, edges;
};

std::vector<std::vector<int>> nodesOf(const CellTopologyData_Subcell* subcells, unsigned count) {
  std::vector<std::vector<int>> result;
  for (unsigned i = 0; i < count; ++i) {
    result.emplace_back(subcells[i].node, subcells[i].node + subcells[i].topology->node_count);
  }
  return result;
}

Topology topology(ElementType type, const char* name, std::vector<const char*> exodusNames,
                  const CellTopologyData* shards) {
  return {type,
          name,
          std::move(exodusNames),
          shards,
          nodesOf(shards->side, shards->side_count),
          nodesOf(shards->edge, shards->edge_count)};
}

const std::array<Topology, 13>& topologies() {
  using namespace shards;
  static const std::array<Topology, 13> all = {
      topology(ElementType::tri3, "TRI3", {"TRI", "TRI3", "TRIANGLE", "TRIANGLE3", "TRISHELL", "TRISHELL3"},
               getCellTopologyData<Triangle<3>>()),
      topology(ElementType::quad4, "QUAD4", {"QUAD", "QUAD4", "QUADRILATERAL", "QUADRILATERAL4", "SHELL", "SHELL4"},
               getCellTopologyData<Quadrilateral<4>>()),
      topology(ElementType::tet4, "TET4", {"TET", "TET4", "TETRA", "TETRA4"}, getCellTopologyData<Tetrahedron<4>>()),
      topology(ElementType::pyramid5, "PYRAMID5", {"PYRAMID", "PYRAMID5", "PYRA", "PYRA5"},
               getCellTopologyData<Pyramid<5>>()),
      topology(ElementType::wedge6, "WEDGE6", {"WEDGE", "WEDGE6"}, getCellTopologyData<Wedge<6>>()),
      topology(ElementType::hex8, "HEX8", {"HEX", "HEX8", "HEXAHEDRON", "HEXAHEDRON8"},
               getCellTopologyData<Hexahedron<8>>()),
      topology(ElementType::tri6, "TRI6", {"TRI", "TRI6", "TRIANGLE", "TRIANGLE6", "TRISHELL", "TRISHELL6"},
               getCellTopologyData<Triangle<6>>()),
      topology(ElementType::quad8, "QUAD8", {"QUAD", "QUAD8", "QUADRILATERAL", "QUADRILATERAL8", "SHELL", "SHELL8"},
               getCellTopologyData<Quadrilateral<8>>()),
      topology(ElementType::quad9, "QUAD9", {"QUAD", "QUAD9", "QUADRILATERAL", "QUADRILATERAL9", "SHELL", "SHELL9"},
               getCellTopologyData<Quadrilateral<9>>()),
      topology(ElementType::tet10, "TET10", {"TET", "TET10", "TETRA", "TETRA10"},
               getCellTopologyData<Tetrahedron<10>>()),
      topology(ElementType::wedge15, "WEDGE15", {"WEDGE", "WEDGE15"}, getCellTopologyData<Wedge<15>>()),
      topology(ElementType::hex20, "HEX20", {"HEX", "HEX20", "HEXAHEDRON", "HEXAHEDRON20"},
               getCellTopologyData<Hexahedron<20>>()),
      topology(ElementType::hex27, "HEX27", {"HEX", "HEX27", "HEXAHEDRON", "HEXAHEDRON27"},
               getCellTopologyData<Hexahedron<27>>()),
  };
  return all;
}

const Topology& topologyOf(ElementType type) {
  return topologies()[static_cast<std::size_t>(type)];
}

std::string inCapitals(const std::string& name) {
  std::string upper;
  for (const char letter : name) upper += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return upper;
}

}  // namespace

int nodesPerElement(ElementType type) {
  return static_cast<int>(topologyOf(type).shards->node_count);
}

int cornersPerElement(ElementType type) {
  return static_cast<int>(topologyOf(type).shards->vertex_count);
}

bool isQuadratic(ElementType type) {
  return nodesPerElement(type) > cornersPerElement(type);
}

ElementType linearType(ElementType type) {
  for (const Topology& candidate : topologies()) {
    if (dimensionOf(candidate.type) == dimensionOf(type) && !isQuadratic(candidate.type) &&
        nodesPerElement(candidate.type) == cornersPerElement(type)) {
      return candidate.type;
    }
  }
  return type;
}

int dimensionOf(ElementType type) {
  return static_cast<int>(topologyOf(type).shards->dimension);
}

const char* exodusName(ElementType type) {
  return topologyOf(type).name;
}

std::optional<ElementType> elementTypeFromExodus(const std::string& name, int dimension, int nodes) {
  const std::string upper = inCapitals(name);
  for (const Topology& candidate : topologies()) {
    if (dimensionOf(candidate.type) != dimension || nodesPerElement(candidate.type) != nodes) continue;
    for (const char* accepted : candidate.exodusNames) {
      if (upper == accepted) return candidate.type;
    }
  }
  return std::nullopt;
}

int sidesBeforeEdges(const std::string& exodusName) {
  return inCapitals(exodusName).find("SHELL") == std::string::npos ? 0 : 2;
}

int sidesPerElement(ElementType type) {
  return static_cast<int>(topologyOf(type).sides.size());
}

const std::vector<int>& sideNodes(ElementType type, int side) {
  return topologyOf(type).sides[side];
}

const std::vector<std::vector<int>>& edgesOf(ElementType type) {
  return topologyOf(type).edges;
}

}  // namespace harmos::mesh
