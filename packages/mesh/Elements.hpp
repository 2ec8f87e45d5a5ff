#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Finds elements by their number, counted from 0 through all blocks. Keeps a reference: the mesh must outlive it and
/// keep its blocks. Numbers that do not exist are not refused.
class Elements {
 public:
  /// Numbers the elements of a mesh, in the order of its blocks.
  explicit Elements(const Mesh& mesh);

  /// Elements of all blocks.
  int count() const { return static_cast<int>(block_.size()); }
  /// Position in Mesh::blocks of an element's block.
  int block(int element) const { return block_[element]; }
  /// Number of the first element of a block.
  int first(int block) const { return first_[block]; }
  /// Position of an element in its block, counted from 0.
  int indexInBlock(int element) const { return element - first(block(element)); }
  /// What kind of element it is, that of its block.
  ElementType type(int element) const;
  /// Mesh node numbers of an element, nodesPerElement(type(element)) of them, owned by the mesh.
  const int* nodes(int element) const;
  /// Mesh node numbers of a side (counted from 0), counter-clockwise seen from outside.
  std::vector<int> side(int element, int side) const;

 private:
  const Mesh& mesh_;
  std::vector<int> block_, first_;
};

/// Coordinates [length] of some mesh nodes, in the order given.
std::vector<base::Vector3> pointsOf(const Mesh& mesh, const std::vector<int>& nodes);

/// For messages: element 1017 of "plate.e" (block "rim"), by the numbers that the user knows.
std::string elementName(const Mesh& mesh, int element);

/// For messages: node 4711 of "plate.e" at (1, 0, 2.5), by the numbers that the user knows.
std::string nodeName(const Mesh& mesh, int node);

}  // namespace harmos::mesh
