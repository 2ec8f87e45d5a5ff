#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// What is meshed and factored as one: a whole part of the scene, or what METIS has cut off one.
struct Piece {
  std::string name;           // of the part, or "<part>.1" and so on; in messages
  std::vector<int> elements;  // mesh element numbers, ascending
  std::vector<int> nodes;     // mesh node numbers, ascending; the position is the part's local node number
  std::string part;           // name of the part of the scene; the same as `name` if it is whole
  int side = 0;               // of the plane that divides the part: -1 behind it, 1 beyond it; 0: none does
};

/// The part that consists of the named blocks. Throws base::Error(input) if a block does not exist, is named twice,
/// there are no elements, or two of them have the same nodes. Nothing of the mesh is kept.
Piece makePiece(const Mesh& mesh, const std::string& name, const std::vector<std::string>& blocks);

/// A piece of the given elements (mesh element numbers, ascending, which is not checked), of the part `part`.
Piece makePiece(const Mesh& mesh, const std::string& name, const std::string& part, std::vector<int> elements);

/// Local number of a mesh node in the piece; -1 if the piece does not have it. O(log n).
int localNode(const Piece& piece, int node);

}  // namespace harmos::mesh
