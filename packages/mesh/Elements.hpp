#pragma once

#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// Finds elements by their number, counted from 0 through all blocks. Keeps a reference: the mesh must outlive it and
/// keep its blocks.
class Elements {
 public:
  explicit Elements(const Mesh& mesh);

  int count() const { return static_cast<int>(block_.size()); }
  int block(int element) const { return block_[element]; }
  /// Number of the first element of a block.
  int first(int block) const { return first_[block]; }
  int indexInBlock(int element) const { return element - first(block(element)); }
  ElementType type(int element) const;
  /// Mesh node numbers of an element, nodesPerElement(type(element)) of them.
  const int* nodes(int element) const;
  /// Mesh node numbers of a side, counter-clockwise seen from outside.
  std::vector<int> side(int element, int side) const;

 private:
  const Mesh& mesh_;
  std::vector<int> block_, first_;
};

/// Coordinates of some mesh nodes.
std::vector<base::Vector3> pointsOf(const Mesh& mesh, const std::vector<int>& nodes);

}  // namespace harmos::mesh
