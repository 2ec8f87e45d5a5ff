#pragma once

#include <functional>
#include <vector>

#include <harmos/base/Matrix.hpp>
#include <harmos/latin/FixedPoint.hpp>
#include <harmos/latin/PairTangents.hpp>
#include <harmos/latin/detail/ClusterMotions.hpp>

namespace harmos::latin {

/// Motions of the parts as rigid bodies that the tangents of the laws hardly resist at a load step: of a rod on soft
/// springs whose other joints all slide. Residuals hardly show them, so that least squares may take long to find them,
/// and what is left of them looks small.
///
/// What moves by R [length], the bodies of a cluster that perfect joints make one, has alpha = k R, and its image is
/// beta = -k R: no body resists. With D the tangents df^/dbeta of pairs, I - J makes of it 2 D k (R1 - R2) on side 1
/// and as much on side 2, back; so the resistance of motions is
///   s^2 = (sum over pairs of 4 n h k |D (R1 - R2)|^2 + sum over sides of h k |b|^2) / (sum over sides of h k |R|^2),
/// n the sides of the interface, k b what springs of eliminated boundaries add to the image; but for the small product
/// of both no less than the square of the smallest singular value of I - J in the metric of states. k: [stress/length],
/// h: [area], D: [-], s: [-]. Motions that eliminated boundaries hold are left out. Laws over whole faces count as
/// perfect. Limit: as ClusterMotions.
class SoftMotions {
 public:
  /// Resistance of motions that corrections are to meet. Others are found soon enough by residuals.
  static constexpr double hardest = 0.02;
  /// That which least squares leave out.
  static constexpr double lost = 2e-7;

  /// A motion of all parts together.
  struct Motion {
    double resistance;           ///< s [-]
    std::vector<double> shares;  ///< of the motions of clusters
  };

  /// Not collective. `fixedPoint` must outlive it.
  explicit SoftMotions(const FixedPoint& fixedPoint);

  /// No part can move, or too many can. Not collective, and the same on every rank.
  bool isEmpty() const { return clusters_.size() == 0; }
  /// Collective. Those at a load step with these tangents that are resisted by less than `limit` [-], but not by
  /// nothing or the round-off of tangents, orthogonal to each other; the softest first. The same on every rank.
  std::vector<Motion> find(const PairTangents& tangents, double limit) const;
  /// Whether nothing but laws resists a motion, in all its digits, so that the image of alpha = k R is -k R.
  /// Not collective, and the same on every rank.
  bool isLeftToLaws(const Motion& motion) const;
  /// alpha = k R [stress], rows of the layout on this rank, of norm 1. Not collective.
  std::vector<double> state(const Motion& motion) const;
  /// Its image -k R + k b [stress], b that of rigid bodies: ClusterMotions::addedAt(); rows of the layout on this rank.
  /// Not collective.
  std::vector<double> image(const Motion& motion) const;
  /// What I - J makes of it [stress], u = k b + 2 D k ((R1 - b1) - (R2 - b2)) on side 1, the second share back on side
  /// 2, rows of the layout on this rank. Not collective.
  std::vector<double> change(const PairTangents& tangents, const Motion& motion) const;

 private:
  /// Turns motions in the space that they span, so that their resistances, which it returns in ascending order, have
  /// their digits however small they are beside each other.
  std::vector<double> resolve(const PairTangents& tangents, base::Matrix& motions) const;
  /// Sum over sides of h k b^T b of motions, a column each. Not collective.
  base::Matrix squaresOfSprings(const base::Matrix& motions) const;
  /// Sum over pairs of 4 n h k (D (R1 - R2))^T D (R1 - R2), of all ranks, with the D of an interface and a pair.
  base::Matrix squaresOf(const base::Matrix& motions, const std::function<base::Frame(int, int)>& tangent) const;
  /// D of a pair, in all its digits where the law is affine.
  base::Frame tangentOf(const PairTangents& tangents, int interfaceIndex, int pair) const;
  /// Shares of a motion, a column.
  base::Matrix column(const Motion& motion) const;
  /// k x [stress] of all rows of the layout, x [length] of an interface, a side and a pair.
  void onEachSide(const std::function<base::Matrix(int, int, int)>& way, std::vector<double>& rows) const;
  /// What of the tangent of a pair may be round-off: a number for the axes of the law that answer at all.
  base::Frame roundOffOf(const PairTangents& tangents, int interfaceIndex, int pair) const;

  const FixedPoint& fixedPoint_;
  ClusterMotions clusters_;
  base::Matrix ofSprings_;  // squaresOfSprings() of each motion of a cluster; empty: there are none
};

}  // namespace harmos::latin
