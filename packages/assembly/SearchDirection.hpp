#pragma once

#include <vector>

#include <Teuchos_Comm.hpp>

#include <harmos/assembly/Assembly.hpp>

namespace harmos::assembly {

/// Search direction k > 0 [stress/length] of every interface node pair, the same on both sides.
///
/// Automatic: k = scale * factor * harmonic mean over the sides of 1 / (h (B D^-1 B^T)_pp), of a node that is a point
/// D/h, with D = diag(K) the mean over the components of the nodes' diagonal entries, so that k does not depend on the
/// frame and friction's cone keeps its shape; three times that where the law bonds. A boundary uses its own side. With
/// a consistent interface mass k is constant over an interface (its area-weighted geometric mean), because only then
/// the operator stays symmetric and the discrete solution independent of k. A boundary with a prescribed traction has a
/// value too, which nothing uses. Where a law softens k is no less than marginOfSoftening times the value below which a
/// line may meet its graph more than once, sides x the steepest fall, whatever the scale. Units: diag(K)
/// [force/length], h [area], `scale` [-]. The values are the same on every rank.
class SearchDirection {
 public:
  /// Measured to be near the optimum on bolted and glued assemblies; the exact value matters little.
  static constexpr double factor = 0.15;
  /// Over 1, the bound at which lines of the local stage are as steep as the graph.
  static constexpr double marginOfSoftening = 2.0;

  /// Collective over comm. `scale` multiplies the automatic value, > 0. Throws base::Error on every rank when a body
  /// has a non-positive diagonal at a node of an interface, or (notConverged) when a law softens by far more than the
  /// stiffness of the parts, on the owner when a matrix is not as substructure::viewOf() wants it. Keeps nothing of the
  /// assembly.
  SearchDirection(const Assembly& assembly, double scale, const Teuchos::Comm<int>& comm);
  /// k [stress/length] of the pairs of an interface, in their order; owned by this object.
  const std::vector<double>& of(int interfaceIndex) const { return k_[interfaceIndex]; }
  /// Interfaces on which the softening of their law has the last word somewhere, in ascending order.
  const std::vector<int>& heldBySoftening() const { return heldBySoftening_; }

 private:
  std::vector<std::vector<double>> k_;
  std::vector<int> heldBySoftening_;
};

}  // namespace harmos::assembly
