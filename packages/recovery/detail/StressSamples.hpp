#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/ElementPoints.hpp>

namespace harmos::recovery {

/// What the elements of a part say where their stress is at its best (elasticity::PointSet::sampling).
struct StressSamples {
  /// Of displacements, dofs x columns [length]. Throws base::Error as elasticity::visitElements().
  StressSamples(const elasticity::ElasticPart& part, const base::Matrix& displacements);

  /// How many an element has.
  int of(int element) const { return static_cast<int>(first[element + 1] - first[element]); }
  /// Stress of a sample: six components x columns.
  const double* at(std::size_t sample) const { return stress.data() + width * sample; }

  std::size_t width;                    ///< six times the columns
  std::vector<std::size_t> first;       ///< of each element, and the end
  std::vector<std::size_t> firstNode;   ///< in `node`, of each element, and the end
  std::vector<int> node;                ///< of the elements, in the piece
  std::vector<base::Vector3> position;  ///< of each sample [length]
  std::vector<double> volume;           ///< likewise [length^3; in the plane times thickness]
  std::vector<double> stress;           ///< likewise, `width` numbers [stress]
};

}  // namespace harmos::recovery
