#pragma once

#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FixedPoint.hpp>

namespace harmos::latin {

/// The motions as rigid bodies of clusters, the bodies that perfect joints make one, in which no eliminated boundary
/// holds them; orthonormal in the metric of states: sum over sides of h k |R|^2 = 1, R [length], k [stress/length],
/// h [area].
///
/// Motions of all clusters together are columns with a share of each. Limit: of more than mostClusters clusters that
/// can move there are none.
class ClusterMotions {
 public:
  /// Of clusters that can move.
  static constexpr std::size_t mostClusters = 40;

  /// Not collective. `fixedPoint` must outlive it.
  explicit ClusterMotions(const FixedPoint& fixedPoint);

  /// Motions of all clusters; 0: too many, or none.
  int size() const { return motions_; }
  /// The first motion of the cluster of a body.
  int first(int body) const { return clusters_[clusterOf_[body]].first; }
  /// A body of the cluster that a motion of all clusters moves most. `shares`: of their motions.
  int mostMoved(const std::vector<double>& shares) const;
  /// The motions of the cluster of a side, R at a pair [length], a column each.
  base::Matrix at(const assembly::Interface& interface, int side, int pair) const;
  /// R1 - R2 [length] of motions of all clusters, a column each.
  base::Matrix jump(const assembly::Interface& interface, int pair, const base::Matrix& motions) const;
  /// What eliminated boundaries resist them by, squared: HeldMotions::squaredResistance(), size() x size().
  const base::Matrix& resistedByBoundaries() const { return resisted_; }

 private:
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
  /// The shapes of a cluster, as motions of one of its bodies about its own centre.
  base::Matrix shapesOf(int body, const Cluster& cluster) const;
  base::Matrix resistedByBoundaries(const Cluster& cluster) const;

  const FixedPoint& fixedPoint_;
  std::vector<Cluster> clusters_;
  std::vector<int> clusterOf_;  // per body
  int motions_ = 0;             // of all clusters
  base::Matrix resisted_;
};

}  // namespace harmos::latin
