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
  std::vector<std::vector<int>> sides;
};

Topology topology(ElementType type, const char* name, std::vector<const char*> exodusNames,
                  const CellTopologyData* shards) {
  Topology result{type, name, std::move(exodusNames), shards, {}};
  for (unsigned side = 0; side < shards->side_count; ++side) {
    const auto& subcell = shards->side[side];
    result.sides.emplace_back(subcell.node, subcell.node + subcell.topology->node_count);
  }
  return result;
}

const std::array<Topology, 6>& topologies() {
  using namespace shards;
  static const std::array<Topology, 6> all = {
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
  };
  return all;
}

const Topology& topologyOf(ElementType type) {
  return topologies()[static_cast<std::size_t>(type)];
}

}  // namespace

int nodesPerElement(ElementType type) {
  return static_cast<int>(topologyOf(type).shards->node_count);
}

int dimensionOf(ElementType type) {
  return static_cast<int>(topologyOf(type).shards->dimension);
}

const char* exodusName(ElementType type) {
  return topologyOf(type).name;
}

std::optional<ElementType> elementTypeFromExodus(const std::string& name, int dimension, int nodes) {
  std::string upper;
  for (const char letter : name) upper += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  for (const Topology& candidate : topologies()) {
    if (dimensionOf(candidate.type) != dimension || nodesPerElement(candidate.type) != nodes) continue;
    for (const char* accepted : candidate.exodusNames) {
      if (upper == accepted) return candidate.type;
    }
  }
  return std::nullopt;
}

int sidesPerElement(ElementType type) {
  return static_cast<int>(topologyOf(type).sides.size());
}

const std::vector<int>& sideNodes(ElementType type, int side) {
  return topologyOf(type).sides[side];
}

}  // namespace harmos::mesh
