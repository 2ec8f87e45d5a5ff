#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <harmos/base/Vector3.hpp>
#include <harmos/mesh/ElementType.hpp>
#include <harmos/mesh/Numbering.hpp>

/// Finite element meshes: blocks, faces, pieces, and the surfaces where they meet. No physics.
namespace harmos::mesh {

/// Elements of one type that share a name; node numbers are 0-based positions in Mesh::nodes.
struct ElementBlock {
  std::string name;                      // by which parts name it
  std::int64_t id = 0;                   // of the Exodus file
  ElementType type = ElementType::hex8;  // of all elements
  std::vector<int> connectivity;         // node numbers, elements() times nodesPerElement(type)
  /// How many elements the block has.
  int elements() const { return static_cast<int>(connectivity.size()) / nodesPerElement(type); }
};

/// Faces (edges in 2-D) of elements. Elements are counted from 0 through all blocks in order, sides from 0 as in Exodus
/// and Shards.
struct SideSet {
  std::string name;          // by which interfaces and boundaries name it
  std::int64_t id = 0;       // of the Exodus file
  std::vector<int> element;  // one per face
  std::vector<int> side;     // of that element, one per face
};

/// Some nodes of the mesh.
struct NodeSet {
  std::string name;       // by which boundaries name it
  std::int64_t id = 0;    // of the Exodus file
  std::vector<int> node;  // positions in Mesh::nodes
};

/// A finite element mesh: what an Exodus file holds, no physics. In 2-D the third coordinate is 0. The unit of length
/// is the user's.
struct Mesh {
  int dimension = 3;                      // 2 or 3
  std::vector<base::Vector3> nodes;       // coordinates (x, y, z) [length]
  std::vector<ElementBlock> blocks;       // number the elements in their order
  std::vector<SideSet> sideSets;          // may share faces
  std::vector<NodeSet> nodeSets;          // may share nodes
  std::vector<std::string> unreadBlocks;  // names of blocks of the file that are not here, because nobody uses them
  Numbering numbering;                    // of elements and nodes in the user's file
};

}  // namespace harmos::mesh
