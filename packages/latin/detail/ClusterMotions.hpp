#pragma once

#include <array>
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
  /// By how much a motion of all clusters of norm 1, given by its shares, may be another one [-]: what boundaries leave
  /// of a partly held body is known to the digits that stiff ones leave of the others.
  double roundOffOf(const double* shares) const;
  /// The motions of the cluster of a side, R at a pair [length], a column each.
  base::Matrix at(const assembly::Interface& interface, int side, int pair) const;
  /// R of motions of all clusters on a side [length], a column each.
  base::Matrix onSide(const assembly::Interface& interface, int side, int pair, const base::Matrix& motions) const;
  /// R1 - R2 [length] of motions of all clusters, a column each.
  base::Matrix jump(const assembly::Interface& interface, int pair, const base::Matrix& motions) const;
  /// q = (L + S)^-1 S R of motions of all clusters, a column each, as shares of them: where alpha = k R drives rigid
  /// bodies with springs S of eliminated boundaries, they lack so much of R. R^T L R = sum over pairs of h k |R1 -
  /// R2|^2 / 2, of one side h k |R|^2: the forces of the linear stage, whose resultants the macro problem balances.
  base::Matrix lacking(const base::Matrix& motions) const;
  /// What is added at a pair to the image -k R then [length, times k], a column for each of such q: 3/2 q1 - 1/2 q2 on
  /// side 1, and the like on side 2, 2 q where there is but one.
  std::array<base::Matrix, 2> addedAt(const assembly::Interface& interface, int pair, const base::Matrix& q) const;
  /// Whether there are such springs.
  bool haveSprings() const { return answers_.numRows() > 0; }

 private:
  struct Cluster {
    std::vector<int> bodies;
    base::Vector3 centre{};
    double size = 0.0;          // [length]
    int first = 0;              // number of its first motion
    bool isPartlyHeld = false;  // boundaries hold some motions of its bodies
    base::Matrix shapes;        // translation [length] and rotation times the size, one motion per column
  };

  void findClusters();
  /// The motions of a cluster that no eliminated boundary holds, columns.
  base::Matrix freeMotions(const Cluster& cluster) const;
  /// Makes the shapes of a cluster, whose products are `squares`, orthonormal, and leaves out what no interface feels.
  static void normalise(Cluster& cluster, base::Matrix squares);
  /// The shapes of a cluster, as motions of one of its bodies about its own centre.
  base::Matrix shapesOf(int body, const Cluster& cluster) const;
  /// S of the springs of eliminated boundaries, size() x size().
  base::Matrix springs() const;
  /// L, see lacking().
  base::Matrix ofInterfaces() const;

  const FixedPoint& fixedPoint_;
  std::vector<Cluster> clusters_;
  std::vector<int> clusterOf_;  // per body
  int motions_ = 0;             // of all clusters
  base::Matrix answers_;        // (L + S)^-1 S; empty: no springs
};

}  // namespace harmos::latin
