#include <harmos/mesh/Elements.hpp>

#include <sstream>

#include <harmos/base/Names.hpp>

namespace harmos::mesh {

Elements::Elements(const Mesh& mesh) : mesh_(mesh) {
  for (std::size_t block = 0; block < mesh.blocks.size(); ++block) {
    first_.push_back(count());
    block_.insert(block_.end(), mesh.blocks[block].elements(), static_cast<int>(block));
  }
}

ElementType Elements::type(int element) const {
  return mesh_.blocks[block(element)].type;
}

const int* Elements::nodes(int element) const {
  const ElementBlock& owner = mesh_.blocks[block(element)];
  return owner.connectivity.data() + indexInBlock(element) * nodesPerElement(owner.type);
}

std::vector<int> Elements::side(int element, int side) const {
  const int* all = nodes(element);
  std::vector<int> result;
  for (const int local : sideNodes(type(element), side)) result.push_back(all[local]);
  return result;
}

std::vector<base::Vector3> pointsOf(const Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<base::Vector3> points;
  for (const int node : nodes) points.push_back(mesh.nodes[node]);
  return points;
}

std::string elementName(const Mesh& mesh, int element) {
  return mesh.numbering.nameOfElement(element) + " (block " +
         base::quoted(mesh.blocks[Elements(mesh).block(element)].name) + ")";
}

std::string nodeName(const Mesh& mesh, int node) {
  std::ostringstream text;
  const base::Vector3& place = mesh.nodes[node];
  text << mesh.numbering.nameOfNode(node) << " at (" << place[0] << ", " << place[1];
  if (mesh.dimension == 3) text << ", " << place[2];
  text << ")";
  return text.str();
}

}  // namespace harmos::mesh
