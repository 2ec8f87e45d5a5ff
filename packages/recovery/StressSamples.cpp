#include <harmos/recovery/detail/StressSamples.hpp>

namespace harmos::recovery {

StressSamples::StressSamples(const elasticity::ElasticPart& part, const base::Matrix& displacements)
    : width(6 * static_cast<std::size_t>(displacements.numCols())) {
  elasticity::visitElements(part, elasticity::PointSet::sampling, displacements,
                            [&](const elasticity::ElementPoints& element) {
                              first.push_back(position.size());
                              firstNode.push_back(node.size());
                              node.insert(node.end(), element.node, element.node + element.nodes);
                              position.insert(position.end(), element.position, element.position + element.points);
                              volume.insert(volume.end(), element.volume, element.volume + element.points);
                              const double* values = element.stress();
                              if (stress.empty()) stress.reserve(width * element.points * part.piece.elements.size());
                              stress.insert(stress.end(), values, values + width * element.points);
                            });
  first.push_back(position.size());
  firstNode.push_back(node.size());
}

}  // namespace harmos::recovery
