#pragma once

#include <map>
#include <vector>

#include <harmos/latin/detail/HeldFaces.hpp>
#include <harmos/latin/detail/RowAlgebra.hpp>

namespace harmos::latin {

/// What a field of tractions is at a pair.
struct TractionAtPair {
  HeldFaces::Pair pair;
  double root = 0.0;         ///< sqrt(h)
  base::Vector3 traction{};  ///< on side 1, times sqrt(h)
};

/// Tractions of the pairs of a cluster of nodes, those that bear anything by themselves: see HeldFaces::axesOf().
class ClusterFields {
 public:
  using Field = std::vector<TractionAtPair>;

  /// Square of what unit fields do to nodes, or of their resultant, below which it is nothing.
  static constexpr double noForce = 1e-10;

  /// `assembly` must outlive it. Not collective.
  ClusterFields(const assembly::Assembly& assembly, const HeldFaces& faces,
                const assembly::NodeClusters::Cluster& cluster);

  /// A traction times sqrt(h) at a pair.
  TractionAtPair at(const HeldFaces::Pair& pair, const base::Vector3& traction) const;
  /// Forces on the nodes that are 0.
  Row none() const { return Row(3 * rows_.size(), 0.0); }
  /// Adds what a traction does to the nodes, over the largest sqrt(h).
  void addForces(const TractionAtPair& at, Row& forces) const;
  /// A basis of fields that no node feels, with orthonormal t sqrt(h).
  std::vector<Field> free() const;
  /// The field that takes as much of forces on the nodes as it can; what it cannot is left in `forces`.
  Field answerTo(Row& forces) const;

 private:
  bool isFree(int mode) const { return values_[mode] <= noForce * values_.back(); }
  Field fieldOf(const Row& factors) const;

  const assembly::Assembly& assembly_;
  std::map<assembly::NodeClusters::Node, std::size_t> rows_;
  double largestRoot_ = 0.0;
  Field unknowns_;            // unit vectors
  std::vector<Row> columns_;  // their forces
  base::Matrix modes_;
  Row values_;
};

}  // namespace harmos::latin
