#pragma once

#include <vector>

#include <harmos/latin/StateMetric.hpp>
#include <harmos/substructure/Precision.hpp>

namespace harmos::latin {

/// The directions v in which the state alpha of one load step may be corrected, and what is known of each.
///
/// Beside every v [stress] stands y = dbeta [stress], its image under the linear stage, which is affine, so that y
/// stays right for ever, and g = (I - J) v, J the tangent of T where it was last asked. The v are orthonormal in the
/// metric of states; of the g, scaled by it, a factorisation Q R with orthonormal Q is kept. All calls are collective
/// but those that say otherwise.
class CorrectionSpace {
 public:
  /// Numbers that a direction takes, over those of a state of one load step: v, y and g.
  static constexpr int statesPerDirection = 3;

  /// `metric`, of a state with one field, must outlive it. `images`: how exactly the y are found, at least, which tells
  /// what small singular values of G are.
  explicit CorrectionSpace(const StateMetric& metric, substructure::Precision images = substructure::Precision::single);

  /// Directions so far. Not collective.
  int size() const { return size_; }
  /// Numbers of a direction on this rank. Not collective.
  int rows() const { return static_cast<int>(metric_->scale().size()); }

  /// Takes from v, rows of the layout, what the space holds already and scales it to length one; false when nothing but
  /// round-off is left.
  bool makeIndependent(double* v) const;
  /// The coefficients of what the space holds of a vector [stress], rows of the layout.
  std::vector<double> coefficients(const double* v) const;
  /// Adds a direction that makeIndependent() has made, with its y; append() must follow for its g. Not collective.
  void add(const double* v, const double* y);
  /// Adds a direction whose y is not known yet; setImage() must follow. Not collective.
  void add(const double* v);
  /// The y of a direction that was added without. Not collective.
  void setImage(int direction, const double* y);
  /// Adds the g [stress], rows of the layout, of the next directions that have none.
  /// Source: Barlow, Smoktunowicz, Reorthogonalized block classical Gram-Schmidt (2013), doi:10.1007/s00211-012-0496-2.
  void append(const base::Matrix& g);
  /// Lets go of Q, which takes as much as all v, and keeps R: after it, forgetTangent() and append() of all g must come
  /// before append(), solve() and rest(). Not collective.
  void releaseBasis() {
    std::vector<double>().swap(orthonormal_);
    isReleased_ = true;
  }
  /// Whether Q is gone. Not collective, and the same on every rank.
  bool isReleased() const { return isReleased_; }
  /// Forgets the g of all directions; append() must follow for each of them. Not collective.
  void forgetTangent() {
    known_ = 0;
    isReleased_ = false;
    hasSingularValues_ = false;
  }

  /// What least squares make of a residual r [stress] of this load step.
  struct LeastSquares {
    std::vector<double> c;  ///< coefficients of the v
    double left = 0.0;      ///< |r - G c| in the metric
  };
  /// min |r - G c|, without directions along which G is singular but for round-off.
  LeastSquares solve(const double* residual) const;
  /// min |r - G c|^2 + e^2 |c|^2 with e = 2e-7: nearly the same, without singular values, which take a dozen times as
  /// long where there are hundreds of directions. `left` is |r - G c| as well.
  /// Source: Golub, Van Loan, Matrix Computations (2013), 6.1.4.
  LeastSquares solveDamped(const double* residual) const;
  /// r - G c [stress]. Not collective.
  std::vector<double> rest(const double* residual, const std::vector<double>& c) const;
  /// Of G: a lower bound of |(I - J) v| over |v| in the space; 1 without directions. Not collective.
  double smallestSingularValue() const;

  /// alpha += length V c and beta += length Y c, rows of the layout. Not collective.
  void move(const std::vector<double>& c, double length, double* alpha, double* beta) const;
  /// y of a direction [stress]. Not collective.
  const double* image(int direction) const { return images_.data() + at(direction); }
  /// v of a direction [stress]. Not collective.
  const double* direction(int direction) const { return directions_.data() + at(direction); }

 private:
  std::size_t at(int column) const { return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(column); }
  /// For `count` more columns, and no more than a few: there is a space for every load step.
  void makeRoom(std::vector<double>& columns, int count) const;
  /// append() of some columns of g together.
  void appendTogether(const base::Matrix& g, int first, int count);
  /// Removes from columns x, scaled, what `count` columns of Q from `first` on hold; returns their coefficients, count
  /// x columns.
  std::vector<double> project(int first, int count, double* x, int columns) const;
  /// The same of one column, twice: the sum of both coefficients.
  std::vector<double> projectTwice(int first, int count, double* x) const;
  /// Makes `count` columns of Q from `first` on orthonormal among themselves; returns the triangle that they were.
  base::Matrix orthonormalise(int first, int count);
  double norm(const double* scaled) const;
  /// Q^T r, and the norm of what of r lies outside of Q, before any of it is fitted.
  LeastSquares projected(const double* residual) const;
  /// |right - R c|.
  double leftInside(const std::vector<double>& right, const std::vector<double>& c) const;
  void findSingularValues() const;
  /// The share of the largest of these singular values below which they are those of round-off.
  double negligibleShare(const std::vector<double>& values) const;
  std::vector<double> scaled(const double* x) const;

  const StateMetric* metric_;
  double singular_;  // share of the largest singular value below which they are those of round-off
  int size_ = 0;
  int known_ = 0;                              // directions whose g is known
  std::vector<double> directions_;             // V
  std::vector<double> images_;                 // Y
  std::vector<double> orthonormal_;            // Q, in the scale of the metric
  std::vector<std::vector<double>> triangle_;  // columns of R
  bool isReleased_ = false;                    // Q is not kept
  mutable bool hasSingularValues_ = false;     // of R, found when asked for
  mutable bool isSingular_ = false;
  mutable double smallest_ = 1.0;
  mutable double negligible_ = 0.0;  // singular values below this share of the largest count as none
};

}  // namespace harmos::latin
