#include <harmos/files/ResultMesh.hpp>

namespace harmos::files {

int ResultMesh::elements() const {
  int sum = 0;
  for (const auto& block : blocks) sum += block.elements();
  return sum;
}

ResultMesh resultMesh(const mesh::Mesh& mesh) {
  ResultMesh result;
  result.dimension = mesh.dimension;
  result.nodes = mesh.nodes;
  for (const auto& block : mesh.blocks)
    result.blocks.push_back(
        {block.name, mesh::exodusName(block.type), mesh::nodesPerElement(block.type), block.connectivity});
  result.sideSets = mesh.sideSets;
  result.nodeSets = mesh.nodeSets;
  if (!mesh.numbering.isSplit) result.elementNumbers = mesh.numbering.element;
  if (mesh.numbering.node.size() == mesh.nodes.size()) result.nodeNumbers = mesh.numbering.node;
  return result;
}

ResultStep zeroStep(const ResultMesh& mesh, const ResultVariables& variables, double time) {
  ResultStep step;
  step.time = time;
  step.nodal.assign(variables.nodal.size(), std::vector<double>(mesh.nodes.size(), 0.0));
  step.element.assign(variables.element.size(), std::vector<double>(mesh.elements(), 0.0));
  step.global.assign(variables.global.size(), 0.0);
  return step;
}

}  // namespace harmos::files
