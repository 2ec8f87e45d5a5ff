#pragma once

#include <string>
#include <vector>

namespace harmos::mesh {

/// The elements of one substructure: a block, several blocks, or one piece of a part that METIS has cut.
struct Part {
  std::string name;
  std::vector<int> elements;  // mesh element numbers, ascending
  std::vector<int> nodes;     // mesh node numbers, ascending; the position is the part's local node number
};

}  // namespace harmos::mesh
