#pragma once

#include <string>

#include <harmos/mesh/ElementType.hpp>

namespace harmos::mesh {

/// A block of a mesh that has not been made yet.
struct BlockSize {
  std::string name;                      ///< of the block
  ElementType type = ElementType::hex8;  ///< of its elements
  double elements = 0.0;                 ///< how many
};

/// Nodes [-] for each element of a large regular mesh, with cells divided as by boxes(); meshes of few elements have
/// more.
double nodesForElement(ElementType type);

/// Nodes [-] with which a node shares elements, itself counted, in the mean over such a mesh: blocks in a row of the
/// stiffness matrix. At surfaces there are fewer.
double meanNeighbours(ElementType type);

}  // namespace harmos::mesh
