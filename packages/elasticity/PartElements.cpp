#include <harmos/elasticity/detail/PartElements.hpp>

#include <algorithm>

#include <harmos/base/Error.hpp>
#include <harmos/base/Names.hpp>
#include <harmos/mesh/Elements.hpp>

namespace harmos::elasticity {

std::vector<ElementGroup> groupsOf(const mesh::Mesh& mesh, const mesh::Piece& piece, Kinematics kinematics) {
  std::vector<ElementGroup> groups;
  int firstOfBlock = 0;
  auto element = piece.elements.begin();
  for (const mesh::ElementBlock& block : mesh.blocks) {
    const int endOfBlock = firstOfBlock + block.elements();
    ElementGroup group;
    group.block = &block;
    group.firstElement = static_cast<int>(element - piece.elements.begin());
    const auto perElement = static_cast<std::size_t>(mesh::nodesPerElement(block.type));
    for (; element != piece.elements.end() && *element < endOfBlock; ++element) {
      const int position = *element - firstOfBlock;
      if (position < 0) throw base::Error("The elements of part \"" + piece.part + "\" are not in ascending order.");
      group.inBlock.push_back(position);
      const int* nodes = block.connectivity.data() + static_cast<std::size_t>(position) * perElement;
      for (std::size_t a = 0; a < perElement; ++a) {
        const auto found = std::lower_bound(piece.nodes.begin(), piece.nodes.end(), nodes[a]);
        if (found == piece.nodes.end() || *found != nodes[a]) {
          throw base::Error("Part " + base::quoted(piece.part) + " lacks " + mesh::nodeName(mesh, nodes[a]) +
                            ", which its " + mesh::elementName(mesh, *element) + " has.");
        }
        group.nodes.push_back(static_cast<int>(found - piece.nodes.begin()));
      }
    }
    if (!group.inBlock.empty()) {
      if (mesh::dimensionOf(block.type) != dimensionOf(kinematics)) {
        throw base::Error("Kinematics " + kinematicsNames()[static_cast<std::size_t>(kinematics)] +
                              " does not suit the " + mesh::exodusName(block.type) + " elements of " +
                              nameOf(mesh, piece, group, 0) + ".",
                          base::ExitCode::input);
      }
      groups.push_back(std::move(group));
    }
    firstOfBlock = endOfBlock;
  }
  if (element != piece.elements.end()) {
    throw base::Error("Part \"" + piece.part + "\" has element " + std::to_string(*element + 1) + "; the mesh has " +
                      std::to_string(firstOfBlock) + " elements.");
  }
  return groups;
}

std::string nameOf(const mesh::Mesh& mesh, const mesh::Piece& piece, const ElementGroup& group, int element) {
  return "part " + base::quoted(piece.part) + ", " +
         mesh::elementName(mesh, piece.elements[group.firstElement + element]);
}

}  // namespace harmos::elasticity
