#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <harmos/elasticity/Kinematics.hpp>
#include <harmos/mesh/Mesh.hpp>
#include <harmos/mesh/Piece.hpp>

namespace harmos::elasticity {

/// The elements of a part that lie in one block, with the part's node numbers. Refers to the mesh.
struct ElementGroup {
  const mesh::ElementBlock* block = nullptr;
  int firstElement = 0;      ///< position of the first one in Piece::elements
  std::vector<int> inBlock;  ///< position in the block
  std::vector<int> nodes;    ///< local nodes of the part: elements x nodesPerElement
  int elements() const { return static_cast<int>(inBlock.size()); }
  int nodesPerElement() const { return mesh::nodesPerElement(block->type); }
  const int* nodesOf(int element) const { return nodes.data() + std::ptrdiff_t{element} * nodesPerElement(); }
};

/// Groups in the order of the blocks, so that their elements follow one another as in Piece::elements.
/// Throws base::Error when an element or a node is not of the mesh or the part, or an element has another dimension
/// than the kinematics.
std::vector<ElementGroup> groupsOf(const mesh::Mesh& mesh, const mesh::Piece& piece, Kinematics kinematics);

/// For messages: part "p", element 12 of "plate.e" (block "b").
std::string nameOf(const mesh::Mesh& mesh, const mesh::Piece& piece, const ElementGroup& group, int element);

}  // namespace harmos::elasticity
