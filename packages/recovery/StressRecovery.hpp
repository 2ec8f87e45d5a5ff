#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/elasticity/ElementPoints.hpp>

/// Stresses recovered from those of finite elements, and what they tell of the error of the mesh.
namespace harmos::recovery {

struct StressSamples;

/// Stress at the nodes of a part, recovered from its elements by one linear map for all displacements.
///
/// Around every node a polynomial of the order of the elements is fitted by least squares to the stress at the sampling
/// points of the elements nearby, weighted by volume; its value at the node is the recovered stress. Singular values
/// below 1e-3 of the largest are dropped. A node takes the elements that it belongs to, and their neighbours where
/// these are too few; at the surface of simplices always. Nothing is averaged over the boundary of the part. Source:
/// Zienkiewicz, Zhu (1992), doi:10.1002/nme.1620330702.
class StressRecovery {
 public:
  /// Recovers from displacements, dofs x columns [length]. `boundary`: whether each node of the part lies on its
  /// surface. Throws base::Error as visitElements(), and when LAPACK fails. Not collective; keeps no reference.
  StressRecovery(const elasticity::ElasticPart& part, const std::vector<bool>& boundary,
                 const base::Matrix& displacements);
  /// The same from what was sampled before.
  StressRecovery(const elasticity::ElasticPart& part, const std::vector<bool>& boundary, const StressSamples& samples);

  /// A column for every node: (six components as elementStress() has them x columns) x nodes [stress].
  const base::Matrix& stress() const { return stress_; }

 private:
  base::Matrix stress_;
};

}  // namespace harmos::recovery
