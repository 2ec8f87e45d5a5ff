#include <harmos/latin/detail/ClusterFields.hpp>

#include <algorithm>
#include <cmath>

#include <harmos/latin/detail/SymmetricEigen.hpp>

namespace harmos::latin {

using assembly::Interface;
using assembly::NodeClusters;

ClusterFields::ClusterFields(const assembly::Assembly& assembly, const HeldFaces& faces,
                             const NodeClusters::Cluster& cluster)
    : assembly_(assembly) {
  for (const NodeClusters::Pair& pair : cluster.pairs) {
    const Interface& interface = assembly.interfaces[pair.interface];
    for (int side = 0; side < interface.sides(); ++side)
      rows_.emplace(std::pair(interface.body(side), interface.trace(side).node(pair.pair)), 3 * rows_.size());
    largestRoot_ = std::max(largestRoot_, std::sqrt(interface.area[pair.pair]));
  }
  // Of clusters that are too large none is taken.
  if (cluster.pairs.size() > NodeClusters::mostPairs) return;
  for (const NodeClusters::Pair& pair : cluster.pairs) {
    for (const base::Vector3& axis : faces.axesOf(pair)) {
      unknowns_.push_back(at(pair, axis));
      columns_.push_back(none());
      addForces(unknowns_.back(), columns_.back());
    }
  }
  if (unknowns_.empty()) return;
  modes_ = productsOf(columns_);
  values_ = symmetricEigen(modes_);
}

TractionAtPair ClusterFields::at(const HeldFaces::Pair& pair, const base::Vector3& traction) const {
  return {pair, std::sqrt(assembly_.interfaces[pair.interface].area[pair.pair]), traction};
}

void ClusterFields::addForces(const TractionAtPair& at, Row& forces) const {
  const Interface& interface = assembly_.interfaces[at.pair.interface];
  for (int side = 0; side < interface.sides(); ++side) {
    const std::size_t row = rows_.at({interface.body(side), interface.trace(side).node(at.pair.pair)});
    const double factor = (side == 0 ? at.root : -at.root) / largestRoot_;
    for (std::size_t c = 0; c < 3; ++c) forces[row + c] += factor * at.traction[c];
  }
}

std::vector<ClusterFields::Field> ClusterFields::free() const {
  std::vector<Field> fields;
  for (int j = 0; j < modes_.numCols(); ++j) {
    if (isFree(j)) fields.push_back(fieldOf({modes_[j], modes_[j] + modes_.numRows()}));
  }
  return fields;
}

ClusterFields::Field ClusterFields::answerTo(Row& forces) const {
  Row factors(unknowns_.size(), 0.0);
  for (int j = 0; j < modes_.numCols(); ++j) {
    if (isFree(j)) continue;
    double work = 0.0;
    for (std::size_t i = 0; i < columns_.size(); ++i) work += modes_[j][i] * dot(columns_[i], forces);
    for (std::size_t i = 0; i < columns_.size(); ++i) factors[i] -= work / values_[j] * modes_[j][i];
  }
  for (std::size_t i = 0; i < columns_.size(); ++i) add(factors[i], columns_[i], forces);
  return fieldOf(factors);
}

ClusterFields::Field ClusterFields::fieldOf(const Row& factors) const {
  Field field = unknowns_;
  for (std::size_t i = 0; i < field.size(); ++i) field[i].traction = factors[i] * field[i].traction;
  return field;
}

}  // namespace harmos::latin
