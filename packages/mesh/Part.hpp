#pragma once

#include <string>
#include <vector>

#include <harmos/mesh/Mesh.hpp>

namespace harmos::mesh {

/// The elements of one substructure: a block, several blocks, or one piece of a part that METIS has cut.
struct Part {
  std::string name;
  std::vector<int> elements;  // mesh element numbers, ascending
  std::vector<int> nodes;     // mesh node numbers, ascending; the position is the part's local node number
  std::string body;           // name of the part before it was cut; the name itself if it is whole
};

/// The part that consists of the named blocks. Throws base::Error(input) if a block does not exist, is named twice,
/// there are no elements, or two of them have the same nodes.
Part makePart(const Mesh& mesh, const std::string& name, const std::vector<std::string>& blocks);

/// A part of the given elements, ascending.
Part makePart(const Mesh& mesh, const std::string& name, const std::string& body, std::vector<int> elements);

/// Local number of a mesh node in the part; -1 if the part does not have it.
int localNode(const Part& part, int node);

}  // namespace harmos::mesh
