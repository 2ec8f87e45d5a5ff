#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/ElementType.hpp>

namespace harmos::mesh {

/// Elements of one type that share a name; node numbers are 0-based positions in Mesh::nodes.
struct ElementBlock {
  std::string name;
  std::int64_t id = 0;
  ElementType type = ElementType::hex8;
  std::vector<int> connectivity;  // elements() times nodesPerElement(type)
  int elements() const { return static_cast<int>(connectivity.size()) / nodesPerElement(type); }
};

/// Faces (edges in 2-D) of elements. Elements are counted from 0 through all blocks in order, sides from 0 as in Exodus
/// and Shards.
struct SideSet {
  std::string name;
  std::int64_t id = 0;
  std::vector<int> element;
  std::vector<int> side;
};

struct NodeSet {
  std::string name;
  std::int64_t id = 0;
  std::vector<int> node;
};

/// A finite element mesh: what an Exodus file holds, no physics. In 2-D the third coordinate is 0.
struct Mesh {
  int dimension = 3;
  std::vector<base::Vector3> nodes;
  std::vector<ElementBlock> blocks;
  std::vector<SideSet> sideSets;
  std::vector<NodeSet> nodeSets;
};

}  // namespace harmos::mesh
