#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/PairTangents.hpp>

namespace harmos::latin {

/// Motions of the parts as rigid bodies that the tangents of the laws hardly resist at a load step: of a rod on soft
/// springs whose other joints all slide. Residuals hardly show them, so that least squares may take long to find them,
/// and what is left of them looks small.
///
/// What moves by R [length], the bodies of a cluster that perfect joints make one, has alpha = k R, and its image is
/// beta = -k R: no body resists. With D the tangents df^/dbeta of pairs, I - J makes of it 2 D k (R1 - R2) on side 1
/// and as much on side 2, back; so the resistance of motions is
///   s^2 = (sum over pairs of 4 n h k |D (R1 - R2)|^2) / (sum over sides of h k |R|^2),
/// n the sides of the interface, no less than the square of the smallest singular value of I - J in the metric of
/// states. k: [stress/length], h: [area], D: [-], s: [-]. Motions that eliminated boundaries hold are left out. Laws
/// over whole faces count as perfect. Limit: of more than mostClusters clusters nothing is looked for.
class SoftMotions {
 public:
  /// A motion of all parts together.
  struct Motion {
    double resistance;           ///< s [-]
    std::vector<double> shares;  ///< of the motions of clusters [length]
  };
  /// Of clusters that can move.
  static constexpr std::size_t mostClusters = 40;

  /// Not collective. `fixedPoint` must outlive it.
  explicit SoftMotions(const FixedPoint& fixedPoint);

  /// Collective. Those at a load step with these tangents that are resisted by less than `limit` [-], but not by
  /// nothing, orthogonal to each other; the softest first. The same on every rank.
  std::vector<Motion> find(const PairTangents& tangents, double limit) const;
  /// alpha = k R [stress], rows of the layout on this rank, of norm 1. Not collective.
  std::vector<double> state(const Motion& motion) const;

 private:
  /// Bodies that move as one; their motions, orthonormal in the metric of states.
  struct Cluster {
    std::vector<int> bodies;
    base::Vector3 centre{};
    double size = 0.0;    // [length]
    int first = 0;        // number of its first motion
    base::Matrix shapes;  // translation [length] and rotation times the size, one motion per column
  };

  void findClusters();
  /// The motions of a cluster that no eliminated boundary holds, columns.
  base::Matrix freeMotions(const Cluster& cluster) const;
  /// Makes the shapes of a cluster, whose products are `squares`, orthonormal, and leaves out what no interface feels.
  static void normalise(Cluster& cluster, base::Matrix squares);
  /// Motions of a side of a pair [length], a column each.
  base::Matrix at(const assembly::Interface& interface, int side, int pair) const;

  const FixedPoint& fixedPoint_;
  std::vector<Cluster> clusters_;
  std::vector<int> clusterOf_;  // per body
  int motions_ = 0;             // of all clusters; 0: too many, or none
};

}  // namespace harmos::latin
